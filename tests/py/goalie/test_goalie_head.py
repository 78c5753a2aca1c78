# SPDX-License-Identifier: Apache-2.0
import math

import kelpie
import pytest
from goalie_world import world_at
from situation.memory import Memory
from skills.head.ellipse_head import EllipseHead, Pan
from skills.head.goalie_head import GoalieHead, Hints, Look
from skills.head.point_scan import Looks, PointScan, beacons
from skills.head.watch import Watch

NEAR_LEFT, FAR_LEFT, FAR_RIGHT, NEAR_RIGHT = (-15, 135), (-15, 405), (375, 405), (375, 135)


def test_one_round_of_the_point_scan_is_shorter_than_a_full_scan():
    assert PointScan(world_at()).period() < 2.0 * Watch.SCAN_PERIOD / 2.0
    assert PointScan(world_at()).period() < 2.0 * 2.0 * Pan.SIDE / Pan.SPEED


def test_beacons_are_looked_at_from_the_near_left_round_to_the_near_right():
    assert beacons(kelpie.FIELDS['2006']) == [NEAR_LEFT, FAR_LEFT, FAR_RIGHT, NEAR_RIGHT]


def scanned(scan, world, seconds):
    """What a head with 360 deg/s sees in frames in which it hardly turns: pans and tilts."""
    world.time_s, pan, looks = scan.start_s, 0.0, []
    while world.time_s < scan.start_s + seconds:
        request = scan.step(world)
        step = max(-12.0, min(12.0, request.head_pan_deg - pan))
        pan += step
        if abs(step) < 3.0:
            looks.append((pan, request.neck_tilt_deg + request.head_nod_deg))
        world.time_s += 1.0 / 30.0
    return looks


def test_all_four_beacons_the_front_and_both_sides_are_seen_in_each_round():
    world = world_at()
    scan = PointScan(world)
    for _ in range(2):
        looks = scanned(scan, world, scan.period())
        for x, y in beacons(world.field):
            lateral = math.degrees(math.atan2(180.0 - x, y - 20.0))
            assert sum(abs(pan - lateral) < 5.0 for pan, _ in looks) >= 1
        for lateral in (-80, -44, 0, 44, 80):
            assert sum(tilt < -15.0 and abs(pan - lateral) < 10.0 for pan, tilt in looks) >= 2


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_a_ball_lost_close_by_is_first_looked_for_low_ahead_then_the_body_turns_to_both_sides(side):
    world = world_at()
    scan = PointScan(world, side)
    looks = scanned(scan, world, Looks.NEAR_TIMES[2])
    rests = [round(pan / 44.0) for pan, tilt in looks if tilt < -15.0]
    turns = [pan for pan, before in zip(rests, [None] + rests) if pan != before]
    assert turns == [0, side, -side] and scan.turn_side(world) == 0.0
    world.time_s = scan.start_s + Looks.NEAR_TIMES[2] + 0.1
    assert side * scan.step(world).head_pan_deg > 0 and scan.turn_side(world) == side
    world.time_s = scan.start_s + Looks.NEAR_TIMES[3] + 0.1
    assert side * scan.step(world).head_pan_deg < 0 and scan.turn_side(world) == -side
    assert scan.searches_near(world)
    world.time_s = scan.start_s + Looks.NEAR_TIMES[4] + 0.1
    assert scan.step(world).head_pan_deg > 50 and scan.turn_side(world) == 0.0
    assert not scan.searches_near(world)


def test_a_head_looks_where_mates_see_the_ball_and_between_on_with_its_scan():
    world, hints = world_at(), Hints()
    eyes = GoalieHead(Memory(), hints)
    world.ball.seconds_since_seen = 5.0
    eyes.enter(world, eyes.search, PointScan(world))
    began, pans = world.time_s, []
    for frame in range(1, 120):
        hints.reported = (180.0 - 60.0, 20.0 + 60.0)   # 45 deg to the left
        world.time_s = began + frame / 30.0
        pans.append(round(eyes.step(world, True).head_pan_deg))
    there = [pan == 45 for pan in pans]
    assert all(there[:14]) and 0.2 < sum(there) / len(there) < 0.4
    hints.reported = None
    eyes.step(world, True)
    assert not eyes.skill.searches_near(world) and eyes.skill.rounds(world) == 0
    assert eyes.skill.start_s == world.time_s


@pytest.mark.parametrize('x, side', [(150.0, 1.0), (210.0, -1.0)])
def test_where_mates_last_saw_a_near_ball_the_search_begins_again_with_the_turns(x, side):
    world, hints = world_at(), Hints()
    eyes = GoalieHead(Memory(), hints)
    world.ball.seconds_since_seen = 5.0
    eyes.enter(world, eyes.search, PointScan(world))
    hints.reported = (x, 30.0)
    eyes.step(world, True)
    hints.reported = None
    eyes.step(world, True)
    assert eyes.skill.searches_near(world)
    world.time_s += Looks.NEAR_TIMES[2] + 0.1
    eyes.step(world, True)
    assert eyes.turn_side(world) == side


def test_a_lost_pose_is_surveyed_after_the_search_close_by():
    """Before, each survey began that search anew, on the same side."""
    world, hints = world_at(), Hints()
    eyes = GoalieHead(Memory(), hints)
    world.ball.present, world.ball.seconds_since_seen, hints.pose_lost = True, 5.0, True
    eyes.enter(world, eyes.search, PointScan(world, 1.0))
    began, surveyed = world.time_s, []
    for frame in range(1, 150):
        world.time_s = began + frame / 30.0
        eyes.step(world, True)
        if eyes.state == eyes.survey:
            surveyed.append(world.time_s - began)
    assert min(surveyed) == pytest.approx(Looks.NEAR_TIMES[-1], abs=0.1)


def test_point_scan_with_a_wrong_heading_looks_ahead_all_the_same():
    world = world_at(heading=-90.0)
    looks = scanned(PointScan(world), world, 2.0)
    assert min(pan for pan, _ in looks) < -50 and max(pan for pan, _ in looks) > 50


@pytest.mark.parametrize('axis, front, wide', [
    (117.0, FAR_LEFT, FAR_LEFT), (63.0, FAR_RIGHT, FAR_RIGHT),
    (149.0, FAR_LEFT, NEAR_LEFT), (31.0, FAR_RIGHT, NEAR_RIGHT)])
def test_glances_of_2004_go_to_the_beacon_along_the_widest_axis(axis, front, wide):
    """In turn among those in front and those in a wider range."""
    world = seeing(world_at())
    c, s = math.cos(math.radians(axis)), math.sin(math.radians(axis))
    world.covariance = [99 * c * c + 1, 99 * c * s, 0, 99 * c * s, 99 * s * s + 1, 0, 0, 0, 1]
    assert glanced_at(EllipseHead(Memory()), world)[:4] == [front, wide, front, wide]


def test_glances_of_2006_go_to_the_landmark_seen_longest_ago():
    world, memory = seeing(world_at()), Memory()
    memory.marks = {mark.kind: 40 - mark.kind for mark in world.field.landmarks}
    assert glanced_at(GoalieHead(memory), world)[0] == NEAR_RIGHT
    looked = glanced_at(GoalieHead(Memory()), world)
    assert set(looked) == {NEAR_LEFT, FAR_LEFT, FAR_RIGHT, NEAR_RIGHT, (180, 540)}


def glanced_at(head, world):
    """Places of the landmarks that the head glances at in 20 s, each seen when it is."""
    looked, was, frame = [], None, 0
    for _ in range(600):
        world.time_s, frame = world.time_s + 1.0 / 30.0, frame + 1
        head.step(world, True)
        if head.state == head.localise and was != head.state:
            looked.append((head.skill.position.x, head.skill.position.y))
            head.memory.marks[head.skill.kind] = frame
        was = head.state
        world.ball.seconds_since_seen = 0.0
    return looked


def test_a_pose_that_jumped_for_good_makes_the_head_survey():
    hints = Hints()
    head, world = GoalieHead(Memory(), hints), seeing(world_at())
    heads(head, world, 1.0)
    hints.gave_in_s = world.time_s
    world.ball.distance = 40.0
    assert heads(head, world, 1.0) == ['track']
    world.ball.distance = 150.0
    assert heads(head, world, 0.2) == ['survey'] and not head.asked


def heads(head, world, seconds, free=True):
    """The states that a head goes through, each once in a row."""
    states = []
    for _ in range(int(30 * seconds)):
        world.time_s += 1.0 / 30.0
        world.ball.seconds_since_seen += 1.0 / 30.0
        head.step(world, free)
        if not states or states[-1] != head.state.__name__:
            states.append(head.state.__name__)
        if head.state in (head.track, head.believed) and world.percepts.ball.present:
            world.ball.seconds_since_seen = 0.0
    return states


def seeing(world, seen=True):
    world.percepts.ball.present = seen
    world.percepts.landmarks = [kelpie.LandmarkPercept(kind=mark.kind)
                                for mark in world.field.landmarks]
    if seen:
        world.ball.seconds_since_seen = 0.0
    return world


def test_head_of_2006_tracks_and_glances_now_and_then():
    states = heads(GoalieHead(Memory()), seeing(world_at()), 12.0)
    assert states[0] == 'track'
    assert 3 <= states.count('localise') <= 5
    assert states[1:4] == ['localise', 'believed', 'track']


@pytest.mark.parametrize('change', ['not free', 'near', 'coming'])
def test_no_glance_while_the_ball_is_near_or_comes(change):
    world = seeing(world_at())
    if change == 'near':
        world.ball.distance = Look.FAR - 1.0
    if change == 'coming':
        world.ball.velocity.y = -Look.STILL - 1.0
    assert heads(GoalieHead(Memory()), world, 8.0, change != 'not free') == ['track']


def test_a_glance_that_finds_no_landmark_is_followed_by_a_survey():
    world = seeing(world_at())
    world.percepts.landmarks = []
    assert 'survey' in heads(GoalieHead(Memory()), world, 5.0)
    head, pans = GoalieHead(Memory()), []
    head.enter(world, head.survey)
    for _ in range(32):
        world.time_s += 1.0 / 30.0
        request = head.step(world, True)
        if head.state == head.survey and request.head_pan_deg not in pans:
            pans.append(request.head_pan_deg)
    assert pans == list(Look.SURVEY)


@pytest.mark.parametrize('lost, coming, surveys', [(True, 0.0, True), (False, 0.0, False),
                                                  (True, -Look.STILL - 1.0, False)])
def test_a_lost_pose_calls_for_a_survey_even_beside_the_ball(lost, coming, surveys):
    hints = Hints()
    world, head = seeing(world_at()), GoalieHead(Memory(), hints)
    world.ball.distance, world.ball.velocity.y, hints.pose_lost = 15.0, coming, lost
    states = heads(head, world, 5.0)
    assert ('survey' in states) is surveys
    assert states.count('survey') <= 5.0 / Look.AGAIN


def test_a_lost_pose_is_mended_before_a_lost_ball_is_looked_for():
    hints = Hints()
    world, head = seeing(world_at(), seen=False), GoalieHead(Memory(), hints)
    world.ball.present, hints.pose_lost = False, True
    assert 'survey' in heads(head, world, 3.0)


def test_a_glance_that_finds_it_is_not():
    world = seeing(world_at())
    assert 'survey' not in heads(GoalieHead(Memory()), world, 12.0)


def test_glances_are_more_frequent_when_the_pose_is_unsure():
    def glances(sd):
        world = seeing(world_at())
        world.position_sd = sd
        return heads(GoalieHead(Memory()), world, 20.0).count('localise')
    assert glances(Look.SURE_SD + 1.0) > 1.5 * glances(Look.SURE_SD - 1.0)


def test_head_of_2006_regains_a_lost_ball_by_belief_then_by_points():
    head, world = GoalieHead(Memory()), seeing(world_at())
    heads(head, world, 0.5)
    assert heads(head, seeing(world, False), 2.0) == ['track', 'believed', 'search']
    world.ball.seconds_since_seen = 0.0
    head.step(world, True)
    assert head.state == head.track


@pytest.mark.parametrize('unseen_s, state', [(0.05, 'track'), (0.15, 'believed'),
                                             (9.0, 'believed')])
def test_after_a_glance_the_ball_is_tracked_when_it_was_seen_since_then(unseen_s, state):
    head, world = GoalieHead(Memory()), seeing(world_at())
    head.enter(world, head.believed)
    world.time_s += 0.1
    world.ball.seconds_since_seen = unseen_s
    head.believed(world)
    assert head.state.__name__ == state


def test_head_of_2004_goes_back_to_the_last_angle_then_to_gps_then_searches():
    head, world = EllipseHead(Memory()), seeing(world_at())
    world.head.head_pan_deg = 33.0
    states = heads(head, world, Look.EVERY_SURE - 0.1)
    assert states == ['track']
    world.percepts.ball.present = False
    states = heads(head, world, 6.0)
    assert states[:6] == ['track', 'localise', 'last_angle', 'believed', 'horizon', 'feet']
    assert states[6] == 'horizon'


def test_last_angle_is_where_the_ball_was_looked_at():
    head, world = EllipseHead(Memory()), seeing(world_at())
    world.head.head_pan_deg = 33.0
    heads(head, world, 1.0)
    world.head.head_pan_deg = 70.0
    head.enter(world, head.last_angle)
    assert head.step(world, True).head_pan_deg == 33.0


def test_search_of_2004_pans_slowly_at_the_horizon_and_quickly_at_the_feet():
    head, world = EllipseHead(Memory()), world_at()
    world.ball.present = False
    head.enter(world, head.horizon)
    pans = {'horizon': [], 'feet': []}
    for _ in range(90):
        world.time_s += 1.0 / 30.0
        request = head.step(world, True)
        pans[head.state.__name__].append((request.head_pan_deg,
                                          request.neck_tilt_deg + request.head_nod_deg))
    for sweep in pans.values():
        assert sweep[0][0] > 75 and min(pan for pan, _ in sweep) < -75
    assert len(pans['feet']) < 0.6 * 30 * 2 * Pan.SIDE / Pan.SPEED
    assert pans['feet'][3][1] < pans['horizon'][3][1] - 20


def test_glances_of_2004_need_the_ball_25_cm_away():
    for away, glances in [(24.0, False), (26.0, True)]:
        world = seeing(world_at())
        world.ball.distance = away
        assert ('localise' in heads(EllipseHead(Memory()), world, 6.0)) == glances
