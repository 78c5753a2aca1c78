# SPDX-License-Identifier: Apache-2.0
"""The numbers of a held ball: how it is carried, turned with, stopped for a kick, carried off an
edge and round somebody, and when it counts as lost. The robot looks up-field from the middle where
nothing else is said, with an empty choice of kicks."""
import math

import kelpie
import pytest
from situation.memory import Memory
from situations import world
from skills.ball.dodge import Dodge, in_the_way, side_by_gaps, side_by_place
from skills.ball.doubt import Doubt, shown
from skills.ball.explored import Explored
from skills.ball.grab_dribble import GrabDribble, turn_towards
from skills.ball.hold import Hold, carry

FIELD = kelpie.FIELDS['2006']


def holding(x=180.0, y=300.0, heading=90.0, plan='grab_dribble_goal', choice=None):
    """It has held the ball for a moment and is about to turn; `choice`: of a kick, at any time."""
    made = world(x, y, heading)
    made.heading_sd_deg, made.time_s = 60.0, 5.0
    made.motion.feeling.ball_held = True
    skill = GrabDribble(Memory(), lambda one, two, overdue: choice, plan)
    skill.hold = Hold(made, 4.9)
    skill.enter(made, skill.turn)
    return made, skill


# The hold

def test_a_held_ball_is_carried_with_the_head_down_and_the_mouth_open():
    command = carry(1.0, 2.0, 3.0)
    walk, head = command.walk, command.head
    assert (walk.forward, walk.left, walk.turn_deg, walk.kind) == (1.0, 2.0, 3.0,
                                                                   kelpie.WALK_DRIBBLE)
    assert (head.neck_tilt_deg, head.head_nod_deg, head.head_pan_deg) == (-52.0, 45.0, 0.0)
    assert command.mouth_open


@pytest.mark.parametrize('turned', [0.0, 90.0, 180.0])
def test_the_way_with_the_ball_is_that_of_odometry_whatever_the_robot_turns(turned):
    made = world()
    hold = Hold(made, 0.0)
    for turn, forward, left in ((0.0, 3.0, 1.0), (turned, 0.0, 0.0), (0.0, 3.0, 1.0)):
        made.odometry.turn_deg, made.odometry.forward, made.odometry.left = turn, forward, left
        hold.update(made)
    wanted = {0.0: math.hypot(6.0, 2.0), 90.0: math.hypot(2.0, 4.0), 180.0: 0.0}[turned]
    assert hold.way == pytest.approx(wanted, abs=1e-9) and hold.turned == turned


@pytest.mark.parametrize('seconds, frames, slipped', [
    (0.44, 30, False), (0.46, 9, False), (0.46, 10, True)])
def test_a_ball_that_is_not_felt_0_45_s_after_the_grab_has_slipped_after_10_frames(seconds, frames,
                                                                                 slipped):
    made = world()
    made.time_s = 20.0
    hold = Hold(made, 19.0)
    made.time_s += seconds
    for _ in range(frames):
        hold.update(made)
    assert hold.slipped is slipped
    made.motion.feeling.ball_held = True
    hold.update(made)
    assert not hold.slipped


# Turning

@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('off, rate, turn', [
    (20.0, 0.0, 80.0), (40.0, 0.0, 130.0), (30.0, 60.0, 88.8), (20.0, 180.0, 25.0),
    (5.0, 0.0, 25.0), (1.6, 0.0, 25.0), (1.4, 0.0, 0.0), (10.0, 300.0, -27.6)])
def test_a_turn_with_the_ball_counts_the_way_that_it_still_goes_in_0_13_s(side, off, rate, turn):
    """4 times what is left, from 25 to 130 deg/s; `rate`: of the turn now, counted up to 130."""
    made = world()
    made.odometry.turn_deg = side * rate / 30.0
    assert turn_towards(made, side * off) == pytest.approx(side * turn)


def test_a_short_frame_counts_as_0_02_s():
    made, skill = holding()
    made.elapsed_s, made.odometry.turn_deg = 0.001, 0.4
    assert turn_towards(made, 20.0) == pytest.approx(4.0 * (20.0 - 0.13 * 20.0))
    made.time_s += 0.2
    assert not skill.still(made)
    made.odometry.turn_deg = 0.29
    assert skill.still(made)


@pytest.mark.parametrize('heading, edge', [(59.0, False), (61.0, True), (-59.0, False),
                                           (-61.0, True)])
def test_by_the_theses_who_looks_within_60_deg_of_the_way_in_is_off_the_edge(heading, edge):
    made, skill = holding(5.0, 300.0, heading)
    made.task.rules = kelpie.RULES_OF_THESIS
    assert skill.at_edge(made) is edge


@pytest.mark.parametrize('plan, y, seconds, carries', [
    ('grab_dribble_goal', 311.0, 1.0, True), ('grab_dribble_goal', 309.0, 1.0, False),
    ('grab_dribble_goal', 474.0, 1.0, True), ('grab_dribble_goal', 476.0, 1.0, False),
    ('grab_dribble_goal', 400.0, 1.79, True), ('grab_dribble_goal', 400.0, 1.81, False),
    ('grab_turn_kick', 400.0, 1.0, False), ('grab_turn_shoot', 400.0, 1.0, True)])
def test_it_carries_on_from_230_to_65_cm_before_the_goal_within_1_8_s(plan, y, seconds, carries):
    made, skill = holding(y=y, plan=plan)
    made.time_s = 4.9 + seconds
    assert skill.should_carry(made) is carries


@pytest.mark.parametrize('middle, turn', [(0.0, 0.0), (10.0, 20.0), (-10.0, -20.0), (30.0, 40.0),
                                          (-30.0, -40.0)])
def test_it_carries_on_at_20_cm_a_second_kept_on_the_middle_of_the_gap(middle, turn):
    made, skill = holding(y=400.0)
    skill.aim.gap = middle + 8.0, middle - 8.0
    walk = skill.carry_on(made).walk
    assert (walk.forward, walk.left, walk.turn_deg) == pytest.approx((20.0, 0.0, turn))


# The stop before a kick

@pytest.mark.parametrize('forward, left, turn, seconds, still', [
    (0.0, 0.0, 0.0, 0.16, False), (0.0, 0.0, 0.0, 0.18, True), (4.9, 0.0, 0.0, 0.18, True),
    (5.1, 0.0, 0.0, 0.18, False), (0.0, -5.1, 0.0, 0.18, False), (4.0, 4.0, 0.0, 0.18, False),
    (0.0, 0.0, 14.9, 0.18, True), (0.0, 0.0, -15.1, 0.18, False), (20.0, 0.0, 0.0, 0.39, False),
    (20.0, 0.0, 0.0, 0.41, True), (0.0, 0.0, 99.0, 0.41, True)])
def test_it_kicks_after_0_17_s_at_rest_or_0_4_in_any_case(forward, left, turn, seconds, still):
    made, skill = holding()
    made.odometry.forward, made.odometry.left = forward / 30.0, left / 30.0
    made.odometry.turn_deg = turn / 30.0
    skill.enter(made, skill.steady)
    made.time_s += seconds
    assert skill.still(made) is still


@pytest.mark.parametrize('state, seconds, after', [
    ('settle', 0.12, 'settle'), ('settle', 0.14, 'turn')])
def test_a_ball_that_is_felt_is_turned_with_after_0_13_s(state, seconds, after):
    made, skill = holding()
    skill.enter(made, getattr(skill, state))
    made.time_s += seconds
    skill.step(made)
    assert skill.state.__name__ == after


@pytest.mark.parametrize('seconds, gives_up', [(0.49, False), (0.51, True)])
def test_a_ball_that_is_not_felt_within_0_5_s_was_not_caught(seconds, gives_up):
    made, skill = holding()
    made.motion.feeling.ball_held = False
    skill.enter(made, skill.settle)
    made.time_s += seconds
    skill.step(made)
    assert skill.done is gives_up is skill.lost_ball


@pytest.mark.parametrize('turned, side, bearing', [
    (19.0, 1.0, 0.0), (21.0, 1.0, -120.0), (-21.0, 1.0, -120.0), (21.0, -1.0, 120.0),
    (21.0, 0.0, -120.0)])
def test_a_lost_ball_is_behind_the_last_turn_if_that_went_20_deg(turned, side, bearing):
    made, skill = holding()
    skill.hold.turned, skill.turn_side = turned, side
    skill.give_up(made, 'slipped')
    assert skill.hint[1] == pytest.approx(bearing)


@pytest.mark.parametrize('seconds, way, overdue', [
    (2.19, 0.0, False), (2.21, 0.0, True), (1.0, 34.9, False), (1.0, 35.1, True)])
def test_it_is_out_of_time_0_8_s_and_15_cm_before_the_rules_are(seconds, way, overdue):
    made, skill = holding()
    made.time_s, skill.hold.x = 4.9 + seconds, way
    skill.keep(made)
    assert (skill.state == skill.overdue) is overdue


# Edges

@pytest.mark.parametrize('x, y, heading, edge', [
    (21.0, 324.0, 90.0, True), (23.0, 324.0, 90.0, False), (339.0, 324.0, 90.0, True),
    (337.0, 324.0, 90.0, False), (180.0, 29.0, -90.0, True), (180.0, 31.0, -90.0, False),
    (60.0, 509.0, 90.0, False), (60.0, 511.0, 90.0, True), (180.0, 520.0, 90.0, False),
    (141.0, 520.0, 90.0, False), (139.0, 520.0, 90.0, True),
    (13.0, 324.0, 59.0, False), (13.0, 324.0, 61.0, True), (13.0, 324.0, -61.0, True),
    (13.0, 324.0, -59.0, False)])
def test_within_22_cm_of_a_line_the_ball_is_at_an_edge_unless_the_robot_looks_in(x, y, heading,
                                                                               edge):
    """The ball is 8 cm ahead; the goal's mouth is no line; in is within 60 deg of (180, 324)."""
    made, skill = holding(x, y, heading)
    assert skill.at_edge(made) is edge


@pytest.mark.parametrize('x, heading, turn', [(20.0, 30.0, -120.0), (20.0, -20.0, 80.0),
                                              (340.0, 150.0, 120.0), (20.0, 100.0, -130.0)])
def test_off_an_edge_it_turns_to_the_middle_of_the_field(x, heading, turn):
    made, skill = holding(x, 324.0, heading)
    skill.enter(made, skill.off_edge)
    skill.at_edge = lambda one: True
    assert skill.off_edge(made).walk.turn_deg == pytest.approx(turn)
    assert skill.inwards(made) == pytest.approx((0.0 if x < 180.0 else 180.0) - heading)


# Round somebody

@pytest.mark.parametrize('near, pixels, cells, way', [
    (50.0, 0, (), False), (19.9, 0, (), True), (50.0, 11, (), False), (50.0, 12, (), True),
    (50.0, 0, ((180.0, 330.0, 11.0),), False), (50.0, 0, ((180.0, 330.0, 12.0),), True),
    (50.0, 0, ((180.0, 344.0, 20.0),), True), (50.0, 0, ((180.0, 346.0, 20.0),), False),
    (50.0, 0, ((180.0, 314.0, 20.0),), False), (50.0, 0, ((180.0, 316.0, 20.0),), True),
    (50.0, 0, ((194.0, 330.0, 20.0),), True), (50.0, 0, ((196.0, 330.0, 20.0),), False),
    (50.0, 0, ((166.0, 330.0, 20.0),), True), (50.0, 0, ((164.0, 330.0, 20.0),), False),
    (50.0, 0, ((174.0, 330.0, 6.0), (186.0, 330.0, 6.0)), True)])
def test_somebody_is_in_the_way_by_infrared_pixels_or_what_was_seen_15_to_45_cm_ahead(near, pixels,
                                                                                   cells, way):
    made = world(180.0, 300.0)
    made.sensors.head_near_distance, made.percepts.obstacles_ahead = near, pixels
    made.obstacles = [kelpie.ObstacleCell(position=kelpie.Point2(x=x, y=y), own=own)
                      for x, y, own in cells]
    assert in_the_way(made) is way


@pytest.mark.parametrize('x, y, side', [
    (100.0, 200.0, 1.0), (260.0, 200.0, -1.0), (100.0, 300.0, -1.0), (260.0, 300.0, 1.0),
    (100.0, 269.0, 1.0), (100.0, 271.0, -1.0), (179.0, 200.0, 1.0), (181.0, 200.0, -1.0),
    (59.0, 200.0, -1.0), (61.0, 200.0, 1.0), (301.0, 200.0, 1.0), (299.0, 200.0, -1.0),
    (261.0, 441.0, 1.0), (99.0, 441.0, -1.0), (261.0, 439.0, 1.0), (90.0, 100.0, 1.0),
    (270.0, 100.0, -1.0)])
def test_algorithm_6_7_goes_round_by_the_field_s_middle_and_from_its_edges_and_upper_corners(x, y,
                                                                                          side):
    assert side_by_place(FIELD, x, y) == side


@pytest.mark.parametrize('left, right, goal, side', [
    ((30.0, 10.0), (-10.0, -20.0), -5.0, 1.0), ((20.0, 10.0), (-10.0, -30.0), 5.0, -1.0),
    (None, (-10.0, -30.0), 5.0, 1.0), ((30.0, 10.0), None, -5.0, -1.0), (None, None, 0.0, 1.0)])
def test_before_the_goal_it_goes_round_by_the_wider_gap_else_on_the_goals_side(left, right, goal,
                                                                             side):
    assert side_by_gaps(left, right, goal) == side


@pytest.mark.parametrize('y, frames', [(414.0, 30), (416.0, 7)])
def test_it_goes_round_for_30_frames_more_and_for_7_where_it_is_the_goalie(y, frames):
    """From 60 cm before its box on, which is 65 deep."""
    made = world(100.0, y)
    made.sensors.head_near_distance = 10.0
    skill = Dodge(made, Memory())
    for _ in range(3):
        command = skill.step(made)
    assert command.walk.left == (-14.0 if y < 415.0 else 14.0) and not skill.done
    made.sensors.head_near_distance = 50.0
    for frame in range(1, frames + 1):
        skill.step(made)
        assert skill.done is (frame == frames)


# What images show of a place

@pytest.mark.parametrize('away, pan, robots, seen', [
    (17.0, 0.0, (), False), (60.0, 0.0, (), True), (219.0, 0.0, (), True), (221.0, 0.0, (), False),
    (15.0, 0.0, (), False), (60.0, 14.0, (), True), (60.0, 19.0, (), False),
    (60.0, 0.0, ((14.0, 59.0),), False), (60.0, 0.0, ((16.0, 59.0),), True),
    (60.0, 0.0, ((-14.0, 59.0),), False), (60.0, 0.0, ((0.0, 61.0),), True)])
def test_an_image_shows_a_ball_16_to_220_cm_off_within_17_deg_of_its_axis_behind_nobody(
        away, pan, robots, seen):
    made = world()
    made.head.head_pan_deg = pan
    made.head.head_nod_deg = 14.25 - math.degrees(math.atan2(15.0, max(away - 10.0, 1.0)))
    made.percepts.robots = [kelpie.RobotPercept(heading_deg=heading, distance=distance)
                            for heading, distance in robots]
    assert shown(made, 0.0, away) is seen


@pytest.mark.parametrize('robot, seen', [(20.0, False), (-20.0, True), (34.0, False), (36.0, True),
                                         (6.0, False), (4.0, True)])
@pytest.mark.parametrize('side', [1.0, -1.0])
def test_a_robot_hides_a_ball_within_15_deg_of_its_direction(robot, seen, side):
    """The ball is 60 cm away, 20 deg to a side, where the head looks."""
    made = world()
    made.head.head_pan_deg, made.head.head_nod_deg = side * 20.0, -3.0
    made.percepts.robots = [kelpie.RobotPercept(heading_deg=side * robot, distance=40.0)]
    angle = math.radians(side * 20.0)
    assert shown(made, -60.0 * math.sin(angle), 60.0 * math.cos(angle)) is seen


@pytest.mark.parametrize('missed, refuted', [(4, False), (5, True)])
def test_five_images_without_a_ball_refute_a_place_until_it_is_seen(missed, refuted):
    made, doubt = world(), Doubt()
    made.percepts.ball.present = False
    made.head.head_nod_deg = 0.0
    for _ in range(missed):
        doubt.update(made, (0.0, 80.0))
    assert doubt.refuted is refuted and doubt.missed == missed
    doubt.update(made, None)
    assert doubt.refuted is refuted
    made.percepts.ball.present = True
    doubt.update(made, (0.0, 80.0))
    assert not doubt.refuted and doubt.missed == 0


@pytest.mark.parametrize('pan, sectors, left, right', [
    (0.0, 5, 30.0, 30.0), (5.0, 4, 30.0, 20.0), (-88.0, 5, 0.0, 0.0)])
def test_an_image_shows_22_deg_to_either_side_in_sectors_of_10(pan, sectors, left, right):
    made, explored = world(), Explored()
    made.head.head_pan_deg = pan
    explored.update(made)
    assert explored.unseen == 36 - sectors
    assert (explored.next_unseen(1.0), explored.next_unseen(-1.0)) == (left, right)


def test_a_turn_shows_what_the_robot_comes_to_look_at():
    made, explored = world(), Explored()
    explored.update(made)
    made.odometry.turn_deg = 40.0
    explored.update(made)
    assert explored.unseen == 36 - 9 and explored.next_unseen(-1.0) == 70.0
    for _ in range(8):
        explored.update(made)
    assert explored.unseen == 0 and explored.next_unseen(1.0) == 360.0
