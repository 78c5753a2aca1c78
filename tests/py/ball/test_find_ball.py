# SPDX-License-Identifier: Apache-2.0
"""The chain's rules as tables of situations, then the skill that follows them."""
import math

import kelpie
import pytest
from lib import hints
from situation.memory import Memory
from skills.ball.doubt import Doubt
from skills.ball.explored import Explored
from skills.ball.find_ball import FindBall, ball_sd
from skills.ball.lost_ball import (CHAIN, SPIN_TURN, Situation, first_step, scan_half_width,
                                   scan_limits, sent_away, spin_head, spin_speed, use_back_off,
                                   use_belief, use_forced, use_hint, use_infrared, use_last_seen,
                                   use_scan, use_spin)
from skills.ball.spin_for_ball import SpinForBall
from skills.head.scan_for_ball import FRAMES_PER_S, LATE_FRAMES, ScanForBall, head_params

ALL_HOLD = dict(frame=100, lost=3, force_until=110, hint_frame=95, ir=8.0, close_lost=10,
                believed=True, distance=20.0)
# What makes each step's condition fail, in the order of the chain.
BLOCKERS = (dict(force_until=99), dict(ir=40.0), dict(hint_frame=None), dict(lost=5),
            dict(lost=26), dict(distance=60.0), dict(scanned=30), dict(turned=SPIN_TURN))


def test_the_chain_is_that_of_figure_62_with_a_walk_elsewhere_at_its_end():
    assert [step[0] for step in CHAIN] == ['forced', 'infrared', 'hint', 'last_seen', 'belief',
                                           'back_off', 'scan', 'spin', 'roam']


@pytest.mark.parametrize('blocked', range(len(CHAIN)))
def test_a_step_comes_when_all_before_it_are_blocked(blocked):
    facts = dict(ALL_HOLD)
    for blocker in BLOCKERS[:blocked]:
        facts.update(blocker)
    assert first_step(Situation(**facts))[0] == CHAIN[blocked][0]


def test_every_reason_fits_a_trace():
    for name, _, reason, number in CHAIN:
        assert len(reason) <= 80 and len(name) <= 24 and reason.count('{}') == 1
        assert number in Situation.__slots__


@pytest.mark.parametrize('use, facts, holds', [
    (use_forced, dict(frame=9, force_until=9), True),
    (use_forced, dict(frame=10, force_until=9), False),
    (use_infrared, dict(ir=11.9, close_lost=65), True),
    (use_infrared, dict(ir=12.0, close_lost=65), False),
    (use_infrared, dict(ir=11.9, close_lost=66), False),
    (use_infrared, dict(ir=11.9, close_lost=65, blocking=True), False),
    (use_hint, dict(frame=25, hint_frame=10), True),
    (use_hint, dict(frame=26, hint_frame=10), False),
    (use_hint, dict(frame=25), False),
    (use_last_seen, dict(lost=4), True), (use_last_seen, dict(lost=5), False),
    (use_belief, dict(lost=25, believed=True), True),
    (use_belief, dict(lost=26, believed=True), False),
    (use_belief, dict(lost=25, believed=False), False),
    (use_back_off, dict(distance=39.9, believed=True), True),
    (use_back_off, dict(distance=40.0, believed=True), False),
    (use_back_off, dict(distance=39.9, believed=False), False),
    (use_back_off, dict(distance=39.9, believed=True, backed=44), True),
    (use_back_off, dict(distance=39.9, believed=True, backed=45), False),
    (use_back_off, dict(distance=39.9, believed=True, left=True), False),
    (use_scan, dict(scanned=29), True), (use_scan, dict(scanned=30), False),
    (use_scan, dict(scanned=0, reach=0.0), False),
    (use_spin, dict(turned=359.9), True), (use_spin, dict(turned=360.0), False),
    (use_spin, dict(turned=0.0, unseen=1), True), (use_spin, dict(turned=0.0, unseen=0), False)])
def test_boundaries(use, facts, holds):
    assert use(Situation(**facts)) is holds


@pytest.mark.parametrize('hint, away', [
    (None, False), (hints.GRAB, False), ((41.0, 0.0), True), ((25.0, -30.0), True),
    ((35.0, 120.0), True), ((35.0, 0.0), False)])
def test_a_hint_tells_whether_the_ball_left_the_feet(hint, away):
    given = None if hint is None else (*hint, 100)
    assert sent_away(given, 159) is away
    assert not sent_away(given, 160)


@pytest.mark.parametrize('distance, speed', [(300.0, 55.0), (120.0, 55.0), (70.0, 57.75),
                                             (20.0, 60.5), (5.0, 60.5), (math.inf, 55.0)])
def test_a_spin_is_a_tenth_faster_for_a_near_ball(distance, speed):
    assert spin_speed(distance, 1.0) == pytest.approx(speed)
    assert spin_speed(distance, -1.0) == pytest.approx(-speed)


@pytest.mark.parametrize('distance, side, joints', [
    (120.1, 1.0, (45.0, -10.0, 0.0)), (120.1, -1.0, (-45.0, -10.0, 0.0)),
    (120.0, 1.0, (30.0, -10.0, -10.0)), (120.0, -1.0, (-30.0, -10.0, -10.0))])
def test_the_head_is_held_ahead_of_a_spin(distance, side, joints):
    assert spin_head(distance, side) == joints


def test_a_scan_is_narrower_for_less_variance_and_keeps_its_limits():
    widths = [scan_half_width(sd, 100.0, 5.0) for sd in range(0, 200, 5)]
    assert widths == sorted(widths) and widths[0] == 20.0 and widths[-1] == 90.0
    widths = [scan_half_width(10.0, 100.0, sd) for sd in range(0, 60, 2)]
    assert widths == sorted(widths) and widths[-1] == 90.0
    assert scan_half_width(10.0, 50.0, 5.0) > scan_half_width(10.0, 100.0, 5.0)
    assert scan_half_width(5.0, 0.0, 0.0) == 90.0


@pytest.mark.parametrize('ball, half, limits', [
    (10.0, 20.0, (-10.0, 30.0)), (80.0, 20.0, (60.0, 88.0)), (-80.0, 90.0, (-88.0, 10.0)),
    (0.0, 90.0, (-88.0, 88.0)), (170.0, 20.0, (88.0, 88.0))])
def test_a_scan_lies_about_the_ball_as_far_as_the_head_goes(ball, half, limits):
    assert scan_limits(ball, half) == limits


def test_hints_are_on_the_side_on_which_the_ball_leaves():
    assert hints.GRAB == (30.0, 0.0)
    assert hints.of_dribble(1.0) == (35.0, -120.0) and hints.of_dribble(-1.0) == (35.0, 120.0)
    assert kelpie.KICKS[kelpie.HEAD_SWIPE_LEFT].hint == (50.0, 30.0)
    assert kelpie.KICKS[kelpie.HEAD_SWIPE_RIGHT].hint == (50.0, -30.0)
    assert kelpie.KICKS[kelpie.UPENN_LEFT].hint == (25.0, 30.0)
    assert kelpie.KICKS[kelpie.UPENN_RIGHT].hint == (25.0, -30.0)
    assert kelpie.KICKS[kelpie.KICK_FORWARD].hint is None


def test_the_width_of_a_covariance_is_that_of_its_widest_axis():
    assert ball_sd([9.0, 0.0, 0.0, 4.0]) == pytest.approx(3.0)
    assert ball_sd([5.0, 4.0, 4.0, 5.0]) == pytest.approx(3.0)


# The skill


class Search:
    """A search on a field where the ball is seen or believed as given, frame by frame."""

    def __init__(self, lost=0, place=(0.0, 100.0)):
        self.world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
        self.world.pose.position.x, self.world.pose.position.y = 180.0, 100.0
        self.world.pose.heading_deg = 90.0
        self.world.head.head_nod_deg = 45.0  # looks up: no image refutes a belief
        self.believe(place)
        self.memory = Memory()
        self.skill = FindBall(self.world, self.memory)
        for _ in range(lost + 1):
            self.world.percepts.ball.present = self.memory.frame == 0
            self.memory.update(self.world)

    def believe(self, place):
        ball = self.world.ball
        ball.present = place is not None
        if place is not None:
            ball.relative.x, ball.relative.y = place
            ball.distance = math.hypot(*place)
            ball.heading_deg = math.degrees(math.atan2(-place[0], place[1]))

    def next(self, seen=False):
        self.world.time_s += 1.0 / 30.0
        self.world.percepts.ball.present = seen
        self.memory.update(self.world)
        return self.skill.step(self.world)

    @property
    def step(self):
        return self.skill.state.__name__


def test_a_lost_ball_is_looked_for_by_one_step_after_the_other():
    search, steps = Search(), []
    for frame in range(900):
        if frame == 150:
            search.believe(None)  # gps gives it up after 5 s
        command = search.next()
        search.world.odometry.turn_deg = command.walk.turn_deg / 30.0
        if not steps or steps[-1][0] != search.step:
            steps.append((search.step, frame + 1))
    assert [step for step, _ in steps] == ['last_seen', 'belief', 'scan', 'spin', 'roam']
    # Unseen frames: 4 that wait, the belief to the 25th, the scan from the 26th for 30.
    assert [frame for _, frame in steps[:4]] == [1, 5, 26, 56]


def test_a_drop_out_of_four_frames_does_not_move_the_head():
    search = Search()
    search.world.head.head_pan_deg, search.world.head.head_nod_deg = 33.0, -4.0
    for _ in range(4):
        head = search.next().head
        search.world.head.head_pan_deg += 2.0  # that it still moves does not matter
        assert (head.aim, head.head_pan_deg, head.head_nod_deg) == (kelpie.AIM_JOINTS, 33.0, -4.0)
    assert search.next().head.aim == kelpie.AIM_POINT


@pytest.mark.parametrize('spin_side, spin_lost, pan', [
    (-1.0, 10, 40.0), (1.0, 10, -20.0), (-1.0, 16, 10.0), (1.0, 16, 10.0)])
def test_after_a_recent_spin_the_head_looks_back_against_it(spin_side, spin_lost, pan):
    search = Search()
    search.memory.spin_side, search.memory.spin_lost = spin_side, spin_lost - 1
    search.world.head.head_pan_deg = 10.0
    assert search.next().head.head_pan_deg == pan


def test_a_forced_look_lasts_to_its_frame_and_turns_with_the_body():
    search = Search()
    search.skill.force(60.0, search.memory.frame + 10)
    search.world.odometry.turn_deg = 6.0
    targets = [search.next().head.target for _ in range(10)]
    assert search.step == 'forced'
    assert math.degrees(math.atan2(-targets[-1].x, targets[-1].y)) == pytest.approx(0.0, abs=0.1)
    search.next()
    assert search.step != 'forced'


def test_a_forced_search_without_a_direction_walks_to_the_belief():
    search = Search(lost=100, place=(0.0, 150.0))
    search.skill.force(None, search.memory.frame + 10)
    command = search.next()
    assert search.step == 'forced' and command.walk.forward > 20.0
    search.believe(None)
    search.next()
    assert search.step != 'forced'


def test_a_head_that_is_lower_than_a_look_reads_the_carpet():
    search = Search(lost=30, place=(0.0, 20.0))
    search.memory.close_lost, search.world.sensors.head_near_distance = 30, 6.0
    search.memory.ir, search.world.head.neck_tilt_deg = 6.0, -50.0
    search.next()
    assert search.step != 'infrared'


def test_a_near_reading_of_infrared_looks_down_and_walks_to_the_belief():
    search = Search(lost=30, place=(0.0, 20.0))
    search.memory.close_lost, search.world.sensors.head_near_distance = 30, 6.0
    search.memory.ir = 6.0
    head = search.next().head
    assert search.step == 'infrared'
    assert (head.head_pan_deg, head.neck_tilt_deg + head.head_nod_deg) == (0.0, -30.0)


@pytest.mark.parametrize('hint, turns', [((25.0, 30.0), 1.0), ((25.0, -30.0), -1.0),
                                         ((35.0, 120.0), 1.0), ((35.0, -120.0), -1.0)])
def test_head_and_body_go_to_a_hint_for_fifteen_frames(hint, turns):
    search = Search(lost=30)
    search.memory.set_hint(*hint)
    for _ in range(15):
        command = search.next()
        assert search.step == 'hint' and command.walk.turn_deg * turns > 0.0
        assert command.head.target.x * turns < 0.0
    search.next()
    assert search.step != 'hint'


def test_a_ball_believed_at_the_feet_is_backed_off_from_at_full_speed_looking_down():
    search = Search(lost=30, place=(0.0, 12.0))
    command = search.next()
    assert search.step == 'back_off'
    assert (command.walk.forward, command.walk.kind) == (-50.0, kelpie.WALK_BACK)
    assert command.head.neck_tilt_deg <= -30.0
    for _ in range(60):
        search.next()
    assert search.step != 'back_off'  # a wall behind must not hold it for ever


def test_a_spin_goes_to_the_side_of_the_belief_and_is_remembered():
    for side in (1.0, -1.0):
        search = Search(lost=100, place=(-60.0 * side, -60.0))
        while search.step != 'spin':
            command = search.next()
        assert command.walk.turn_deg * side > 0.0
        assert search.memory.spin_side == side and search.memory.spin_lost == 0


def test_a_ball_seen_again_starts_the_search_anew():
    search = Search(lost=100)
    while search.step != 'spin':
        search.next()
    search.next(seen=True)
    assert search.step == 'last_seen'
    for _ in range(55):
        search.next()
        assert search.step != 'spin'
    search.next()
    assert search.step == 'spin'


def test_a_belief_that_five_images_refute_is_a_belief_no_longer():
    search = Search()
    search.world.head.head_nod_deg = 0.0
    steps = []
    for _ in range(6):
        search.next()
        steps.append(search.step)
    assert steps == ['last_seen'] * 4 + ['scan'] * 2
    search.next(seen=True)
    assert not search.skill.doubt.refuted


def test_whoever_lost_the_ball_has_looked_for_it_there_since():
    search = Search(lost=8)
    search.world.head.head_nod_deg = 0.0
    search.next()
    assert search.step == 'scan'


def test_a_hint_that_five_images_refute_is_followed_no_longer():
    search = Search(lost=30)
    search.world.head.head_nod_deg = -25.0
    search.memory.set_hint(30.0, 0.0)
    steps = []
    for _ in range(6):
        search.next()
        steps.append(search.step)
    assert steps == ['hint'] * 4 + ['scan'] * 2


@pytest.mark.parametrize('place, robot, refuted', [
    ((0.0, 100.0), None, True), ((0.0, 21.0), None, False), ((0.0, 230.0), None, False),
    ((60.0, 100.0), None, False), ((0.0, 100.0), (60.0, 10.0), False),
    ((0.0, 100.0), (160.0, 10.0), True), ((0.0, 100.0), (60.0, 20.0), True)])
def test_only_a_place_that_is_in_sight_can_be_refuted(place, robot, refuted):
    search, doubt = Search(place=place), Doubt()
    search.world.head.head_nod_deg, search.world.percepts.ball.present = 0.0, False
    if robot is not None:
        search.world.percepts.robots = [kelpie.RobotPercept(distance=robot[0],
                                                            heading_deg=robot[1])]
    for _ in range(5):
        doubt.update(search.world, place)
    assert doubt.refuted is refuted


def test_without_a_belief_the_scan_goes_to_the_other_side_first_and_turns_with_the_second_sweep():
    search = Search(lost=30, place=None)
    for frame in range(4):
        command = search.next()
        head = command.head
        assert command.walk.turn_deg == 0.0
        if frame < 3:  # past the feet
            assert (head.head_pan_deg, head.neck_tilt_deg) == (-88.0, -30.0)
    assert head.aim == kelpie.AIM_DIRECTION
    assert (head.direction_deg, head.elevation_deg) == (-88.0, -20.0)
    search.world.head.head_pan_deg = -50.0  # four frames later it will be there
    command = search.next()
    assert (command.head.direction_deg, command.walk.turn_deg) == (88.0, 110.0)
    search.world.head.head_pan_deg = 50.0
    search.next()
    search.next()
    assert search.step == 'spin'  # both sides were shown


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_a_spin_by_itself_is_as_fast_as_algorithm_6_2_has_it(side):
    skill = SpinForBall(Memory(), side)
    assert skill.step(Search().world).walk.turn_deg == pytest.approx(55.0 * side)


def test_a_spin_ends_when_all_around_was_looked_at():
    search, turned = Search(lost=100, place=None), 0.0
    late_head = LateHead(search.world)
    for _ in range(500):
        command = search.next()
        late_head.follow(command.head)
        search.world.odometry.turn_deg = command.walk.turn_deg / 30.0
        turned += search.world.odometry.turn_deg
        if search.step == 'roam':
            break
    assert search.step == 'roam' and 100.0 < turned < 200.0  # the head reaches 220 deg alone


def test_what_was_looked_at_is_counted_in_sectors_and_turns_with_the_body():
    explored, world = Explored(), kelpie.WorldFrame()
    explored.update(world)
    assert explored.unseen == 31  # within 22 deg: -20 to 20
    assert explored.next_unseen(1.0) == 30.0 and explored.next_unseen(-1.0) == 30.0
    world.odometry.turn_deg = 20.0
    explored.update(world)
    assert explored.unseen == 29 and explored.next_unseen(-1.0) == 50.0
    world.odometry.turn_deg = 10.0
    for _ in range(36):
        explored.update(world)
    assert explored.unseen == 0 and explored.next_unseen(1.0) == 360.0


def test_one_sighting_that_gps_does_not_take_does_not_start_the_search_anew():
    search = Search(lost=100, place=None)
    while search.step != 'spin':
        search.next()
        search.skill.scanned += 3
    for seconds_since_seen, step in ((2.0, 'spin'), (0.0, 'scan')):
        search.world.ball.present = True
        search.world.ball.seconds_since_seen = seconds_since_seen
        search.next(seen=True)
        search.world.ball.present = False
        for _ in range(5):
            search.next()
        assert search.step == step


def test_plain_spinning_turns_from_the_first_frame_on():
    search = Search(place=(-50.0, 0.0))
    search.world.task.search = kelpie.SEARCH_BY_SPIN
    for _ in range(900):
        command = search.next()
        search.world.odometry.turn_deg = command.walk.turn_deg / 30.0
        assert search.step == 'spin' and 55.0 <= command.walk.turn_deg <= 60.5


def test_a_step_says_why():
    search = Search(lost=9)
    search.next()
    trace = []
    search.skill.explain(trace)
    assert trace == [(kelpie.LAYER_SKILL, 'find_ball', 'belief',
                      'unseen for {} frames: where gps believes it', 10)]


def test_a_search_without_a_memory_keeps_its_own():
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.ball.present, world.ball.seconds_since_seen, world.ball.distance = True, 1.5, 200.0
    skill = FindBall(world)
    skill.step(world)
    assert skill.state == skill.scan


@pytest.mark.parametrize('unseen_s, state', [(0.05, 'last_seen'), (0.4, 'belief'), (2.0, 'scan')])
def test_a_search_without_a_memory_begins_where_gps_lost_the_ball(unseen_s, state):
    search = Search()
    search.world.ball.seconds_since_seen = unseen_s
    search.world.percepts.ball.present = False
    skill = FindBall(search.world)
    skill.step(search.world)
    assert skill.state.__name__ == state


def test_who_just_lost_the_ball_has_not_looked_for_it_yet():
    search = Search(lost=3)
    search.world.head.head_nod_deg = 0.0
    search.skill = FindBall(search.world, search.memory)
    steps = []
    for _ in range(5):
        search.next()
        steps.append(search.step)
    assert steps == ['last_seen'] + ['belief'] * 3 + ['scan']


# The scan's head


class LateHead:
    """A head whose pan follows what was asked for LATE_FRAMES ago, as fast as was asked."""

    def __init__(self, world):
        self.world, self.asked = world, []

    def follow(self, head):
        self.asked.append(head)
        if len(self.asked) > LATE_FRAMES:
            head = self.asked[-1 - LATE_FRAMES]
            step = (head.speed_deg or 360.0) / FRAMES_PER_S
            pan = head.direction_deg if head.aim == kelpie.AIM_DIRECTION else head.head_pan_deg
            away = pan - self.world.head.head_pan_deg
            self.world.head.head_pan_deg += max(-step, min(step, away))


def swept(scan, seconds, limits):
    """Pans of a head that follows a scan, and the pitches asked for."""
    world, pans, pitches = kelpie.WorldFrame(), [], []
    late_head = LateHead(world)
    for _ in range(round(seconds * FRAMES_PER_S)):
        world.time_s += 1.0 / FRAMES_PER_S
        head = scan.step(world, (*limits, False))
        late_head.follow(head)
        pans.append(world.head.head_pan_deg)
        pitches.append(head.neck_tilt_deg + head.head_nod_deg)
    return pans, pitches


def test_a_scan_sweeps_its_limits_low_at_8_and_high_at_9_degrees_a_frame():
    pans, pitches = swept(ScanForBall(), 4.0, (-60.0, 60.0))
    assert -60.0 <= min(pans) < -50.0 and 50.0 < max(pans) <= 60.0
    assert set(pitches) == {-10.0, 10.0}
    steps = {(pitch, round(abs(b - a))) for a, b, pitch in zip(pans, pans[1:], pitches[1:])}
    assert {(-10.0, 8), (10.0, 9)} <= steps


def test_a_scan_of_one_second_sees_all_the_head_reaches_once():
    pans, _ = swept(ScanForBall(), 1.1, (-88.0, 88.0))
    assert min(pans) < -60.0 and max(pans) > 80.0  # half an image is 28 deg


def test_a_head_that_does_not_arrive_is_turned_all_the_same():
    scan, world, ends = ScanForBall(), kelpie.WorldFrame(), set()
    for _ in range(90):
        world.time_s += 1.0 / FRAMES_PER_S
        ends.add(scan.step(world, (40.0, 88.0, False)).head_pan_deg)
    assert ends == {40.0, 88.0}


def test_what_the_nod_may_not_go_down_the_neck_does():
    head = head_params(95.0, -10.0, -20.0)
    assert (head.head_pan_deg, head.neck_tilt_deg, head.head_nod_deg) == (88.0, -25.0, -5.0)
