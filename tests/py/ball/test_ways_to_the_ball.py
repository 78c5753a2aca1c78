# SPDX-License-Identifier: Apache-2.0
"""The walks of who plays a ball without a grab: to it, around it, the last steps, and through it.
Speeds in cm/s and deg/s, places in cm to the right and ahead of the neck."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from situation.memory import Memory
from situations import world
from skills.ball.dribble import Dribble
from skills.ball.go_to_ball import GoToBall, behind
from skills.ball.kick_ball import KickBall
from skills.ball.line_up import CircleBall, aim_error
from skills.ball.paw_kick import PawKick
from skills.ball.strike import StepToKick


def ball_at(right, ahead, unseen_s=0.0):
    """The robot looks up-field from (180, 200)."""
    made = world(180.0, 200.0, 90.0, (180.0 + right, 200.0 + ahead))
    made.ball.seconds_since_seen = unseen_s
    return made


def aside(degrees, away):
    """A point so many deg to the left."""
    angle = math.radians(degrees)
    return -away * math.sin(angle), away * math.cos(angle)


def numbers(walk):
    return walk.forward, walk.left, walk.turn_deg


# To the ball

@pytest.mark.parametrize('away, forward', [(200.0, 34.0), (45.0, 34.0), (36.0, 27.2), (13.0, 10.0)])
def test_a_ball_is_walked_to_at_34_and_slower_from_45_cm_on_but_10_at_least(away, forward):
    assert numbers(GoToBall().step(ball_at(0.0, away), None)) == pytest.approx((forward, 0.0, 0.0))


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('off_deg, forward, turn', [
    (30.0, 34.0 * math.cos(math.radians(30.0)), 54.0), (38.0, 34.0 * math.cos(math.radians(38.0)),
                                                        68.4),
    (49.0, 34.0 * math.cos(math.radians(49.0)), 70.0), (51.0, 0.0, 70.0), (170.0, 0.0, 70.0)])
def test_it_turns_by_1_8_of_the_angle_and_from_50_deg_on_on_the_spot(side, off_deg, forward, turn):
    walk = GoToBall().step(ball_at(*aside(side * off_deg, 100.0)), None)
    assert numbers(walk) == pytest.approx((forward, 0.0, side * turn))


@pytest.mark.parametrize('goal, place', [
    ((0.0, 300.0), (0.0, 78.0)), ((100.0, 100.0), (-22.0, 100.0)), ((-30.0, 140.0), (13.2, 82.4)),
    (None, (0.0, 100.0))])
def test_the_place_behind_the_ball_is_22_cm_from_it_seen_from_the_goal(goal, place):
    assert behind((0.0, 100.0), goal) == pytest.approx(place)


def test_a_place_beyond_the_ball_is_not_walked_to():
    assert GoToBall().step(ball_at(20.0, 100.0), (20.0, 0.0)).turn_deg == pytest.approx(
        1.8 * math.degrees(math.atan2(-20.0, 100.0)))
    assert GoToBall().step(ball_at(20.0, 100.0), (120.0, 100.0)).turn_deg == pytest.approx(
        1.8 * math.degrees(math.atan2(2.0, 100.0)))


# Around the ball

@pytest.mark.parametrize('ball, goal, error', [
    ((0.0, 20.0), (0.0, 100.0), 0.0), ((0.0, 20.0), (-80.0, 100.0), 45.0),
    ((0.0, 20.0), (80.0, 100.0), -45.0), ((20.0, 20.0), (20.0, 100.0), 45.0),
    ((0.0, 20.0), (-50.0, 20.0), 90.0)])
def test_the_aim_is_off_by_the_goals_direction_from_the_ball_less_the_balls(ball, goal, error):
    assert aim_error(ball, goal) == pytest.approx(error)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('error, left, turn', [
    (10.0, -4.0, 11.46), (30.0, -12.0, 34.38), (45.0, -15.0, 42.975), (100.0, -15.0, 42.975)])
def test_it_steps_round_the_ball_by_0_4_of_the_angle_at_15_at_most_and_keeps_facing_it(side, error,
                                                                                     left, turn):
    x, y = aside(side * error, 100.0)
    walk = CircleBall().step(ball_at(0.0, 20.0), (x, 20.0 + y))
    assert numbers(walk) == pytest.approx((0.0, side * left, side * turn), abs=0.01)


@pytest.mark.parametrize('away, forward', [(20.0, 0.0), (25.0, 6.0), (15.0, -6.0), (30.0, 10.0),
                                           (8.0, -10.0)])
def test_around_the_ball_it_keeps_20_cm_away(away, forward):
    walk = CircleBall().step(ball_at(0.0, away), (0.0, 300.0))
    assert numbers(walk) == pytest.approx((forward, 0.0, 0.0))


@pytest.mark.parametrize('away, turn', [(10.0, 23.875), (12.0, 23.875), (24.0, 11.9375)])
def test_beside_a_ball_nearer_than_12_cm_it_turns_no_faster(away, turn):
    x, y = aside(12.5, 100.0)
    assert CircleBall().step(ball_at(0.0, away), (x, away + y)).turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('bearing, steps', [(39.0, True), (41.0, False)])
def test_a_ball_40_deg_to_a_side_is_faced_first(side, bearing, steps):
    x, y = aside(side * bearing, 26.0)
    walk = CircleBall().step(ball_at(x, y), (3.0 * x, 3.0 * y - 10.0))
    assert (walk.forward > 0.0) is steps and walk.turn_deg * side > 60.0
    assert (walk.left != 0.0) is steps


@pytest.mark.parametrize('bearing, turn', [(20.0, 40.0), (34.0, 68.0), (60.0, 70.0),
                                           (-60.0, -70.0)])
def test_it_faces_the_ball_by_twice_the_angle_and_at_70_at_most(bearing, turn):
    x, y = aside(bearing, 20.0)
    assert CircleBall().step(ball_at(x, y), (3.0 * x, 3.0 * y)).turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('before', [1.0, -1.0])
@pytest.mark.parametrize('error, found', [(149.0, 149.0), (-149.0, -149.0), (151.0, None),
                                          (-151.0, None)])
def test_a_goal_straight_behind_is_gone_round_to_on_the_side_of_before(before, error, found):
    circle = CircleBall()
    circle.side = before
    x, y = aside(error, 100.0)
    aim = circle.aim((0.0, 20.0), (x, 20.0 + y))
    assert aim == pytest.approx(found if found is not None else before * 150.0)
    assert circle.side == (math.copysign(1.0, error) if found is not None else before)


@pytest.mark.parametrize('before', [1.0, -1.0])
def test_without_a_goal_it_goes_on_round_the_ball(before):
    circle = CircleBall()
    circle.side = before
    assert circle.aim((0.0, 20.0), None) == before * 90.0
    assert circle.step(ball_at(0.0, 20.0), None).left == before * -15.0


# The last steps: the ball is struck 14 cm ahead.

@pytest.mark.parametrize('right, ahead, aim, can', [
    (0.0, 14.0, 0.0, True), (1.7, 14.0, 0.0, True), (-1.7, 14.0, 0.0, True),
    (1.9, 14.0, 0.0, False), (-1.9, 14.0, 0.0, False), (0.0, 12.5, 0.0, True),
    (0.0, 12.3, 0.0, False), (0.0, 15.3, 0.0, True), (0.0, 15.5, 0.0, False),
    (0.0, 14.0, 13.5, True), (0.0, 14.0, -13.5, True), (0.0, 14.0, 14.5, False),
    (0.0, 14.0, -14.5, False)])
def test_a_kick_hits_from_12_4_to_15_4_cm_ahead_1_8_aside_and_14_deg_off_the_goal(right, ahead, aim,
                                                                                can):
    x, y = aside(aim, 100.0)
    goal = right + x, ahead + y
    assert StepToKick().can_kick(ball_at(right, ahead), goal) is can


@pytest.mark.parametrize('right, ahead, unseen_s, aim, lost', [
    (0.0, 20.0, 0.0, 0.0, False), (0.0, 44.9, 0.0, 0.0, False), (0.0, 45.1, 0.0, 0.0, True),
    (0.0, -0.1, 0.0, 0.0, True), (0.0, 0.5, 0.0, 0.0, False), (8.9, 20.0, 0.0, 0.0, False),
    (9.1, 20.0, 0.0, 0.0, True),
    (-9.1, 20.0, 0.0, 0.0, True), (0.0, 20.0, 1.4, 0.0, False), (0.0, 20.0, 1.6, 0.0, True),
    (0.0, 20.0, 0.0, 27.5, False), (0.0, 20.0, 0.0, 28.5, True), (0.0, 20.0, 0.0, -28.5, True)])
def test_small_steps_end_for_a_ball_behind_aside_or_unseen_and_28_deg_off_the_goal(
        right, ahead, unseen_s, aim, lost):
    x, y = aside(aim, 100.0)
    goal = right + x, ahead + y
    assert StepToKick().out_of_reach(ball_at(right, ahead, unseen_s), goal) is lost


@pytest.mark.parametrize('right, ahead, forward, left', [
    (0.0, 24.0, 15.0, 0.0), (0.0, 40.0, 26.0, 0.0), (0.0, 18.0, 8.0, 0.0), (0.0, 13.0, -1.5, 0.0),
    (0.0, 12.0, -8.0, 0.0), (2.0, 24.0, 15.0, -3.0), (-2.0, 24.0, 15.0, 3.0),
    (4.0, 24.0, 9.0, -6.0), (-4.0, 24.0, 9.0, 6.0), (6.0, 24.0, 9.0, -7.0), (4.0, 18.0, 0.0, -6.0),
    (4.0, 16.0, -3.0, -6.0), (4.0, 19.0, 1.5, -6.0)])
def test_the_last_steps_go_by_1_5_of_the_way_to_14_cm_or_to_18_while_the_ball_is_3_cm_aside(
        right, ahead, forward, left):
    walk = StepToKick().step(ball_at(right, ahead), (right, 300.0))
    assert numbers(walk) == pytest.approx((forward, left, 0.0))


@pytest.mark.parametrize('aim, turn', [(20.0, 24.0), (40.0, 30.0), (-20.0, -24.0), (-40.0, -30.0)])
def test_the_last_steps_turn_by_1_2_of_the_angle_to_the_goal_at_30_at_most(aim, turn):
    x, y = aside(aim, 100.0)
    assert StepToKick().step(ball_at(0.0, 20.0), (x, 20.0 + y)).turn_deg == pytest.approx(turn)
    assert StepToKick().step(ball_at(0.0, 20.0), None).turn_deg == 0.0


# Driving it on

def driving(goal_deg=0.0, right=0.0, ahead=50.0, seconds=0.0):
    made, skill = ball_at(right, ahead), Dribble(Memory(), lambda one: goal_deg)
    skill.step(made)
    made.time_s += seconds
    return skill, skill.step(made).walk


def test_a_ball_is_driven_on_at_40_with_the_fast_walk_for_4_s_at_most():
    skill, walk = driving(seconds=3.9)
    assert numbers(walk) == pytest.approx((40.0, 0.0, 0.0)) and walk.kind == kelpie.WALK_FAST
    assert not skill.done and not skill.committed
    skill, walk = driving(seconds=4.1)
    assert numbers(walk) == (0.0, 0.0, 0.0) and skill.done


@pytest.mark.parametrize('goal_deg, lateral', [(20.0, 2.0), (40.0, 4.0), (100.0, 4.0),
                                               (-20.0, -2.0), (-100.0, -4.0)])
def test_the_ball_is_met_1_mm_aside_for_each_degree_of_the_goal_and_4_cm_at_most(goal_deg, lateral):
    bearing = math.degrees(math.atan2(-lateral, 50.0))
    _, walk = driving(goal_deg)
    assert walk.turn_deg == pytest.approx(2.0 * bearing)
    assert walk.forward == pytest.approx(40.0 * math.cos(math.radians(bearing)))


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('bearing, forward, turn', [
    (40.0, 40.0 * math.cos(math.radians(40.0)), 80.0), (49.0, 40.0 * math.cos(math.radians(49.0)),
                                                        98.0),
    (51.0, 0.0, 100.0), (90.0, 0.0, 100.0)])
def test_a_ball_50_deg_to_a_side_is_turned_to_first(side, bearing, forward, turn):
    _, walk = driving(side * bearing, *aside(side * bearing, 60.0))
    assert numbers(walk) == pytest.approx((forward, 0.0, side * turn))


@pytest.mark.parametrize('goal_deg, ahead, ends', [
    (109.0, 30.0, False), (111.0, 30.0, True), (-109.0, 30.0, False), (-111.0, 30.0, True),
    (111.0, 39.0, True), (111.0, 41.0, False)])
def test_a_near_ball_is_not_driven_on_with_the_goal_110_deg_off_its_way(goal_deg, ahead, ends):
    assert driving(goal_deg, ahead=ahead)[0].done is ends


# The leg that meets the ball (thesis 2004 section 4.2.2)

@pytest.mark.parametrize('right, side', [(0.1, 1.0), (-0.1, -1.0)])
def test_the_leg_on_the_balls_side_5_cm_from_the_middle_runs_at_it(right, side):
    made = world(180.0, 20.0, 90.0, (180.0 + right, 60.0))
    skill, trace = PawKick(), []
    walk = skill.step(made)
    bearing = math.degrees(math.atan2(side * 5.0 - right, 40.0))
    assert walk.turn_deg == pytest.approx(3.0 * bearing) and walk.forward == pytest.approx(34.0)
    skill.explain(trace)
    assert trace[0][2] == ('right' if side > 0.0 else 'left')


@pytest.mark.parametrize('right, turn', [(35.0, -120.0), (-35.0, 120.0), (20.0, -110.6)])
def test_it_turns_by_three_times_the_angle_and_at_120_at_most(right, turn):
    walk = PawKick().step(world(180.0, 20.0, 90.0, (180.0 + right, 40.0)))
    assert walk.turn_deg == pytest.approx(turn, abs=0.1)


def test_a_ball_beside_the_robot_is_run_at_as_if_it_lay_1_cm_ahead():
    walk = PawKick().step(world(180.0, 30.0, 90.0, (185.5, 27.0)))
    assert walk.turn_deg == pytest.approx(3.0 * math.degrees(math.atan2(-0.5, 1.0)))


# Up to the place of a kick without a grab

def kicking(which=kelpie.UPENN_LEFT, off_ahead=0.0, off_left=0.0, seconds=0.0):
    """The ball lies so far beyond the kick's place, and to the left of it."""
    ahead, left = kelpie.KICKS[which].place
    made = ball_at(-left - off_left, ahead + off_ahead)
    skill = KickBall(Memory(), which)
    skill.entered_s = 0.0
    made.time_s = seconds
    return skill, skill.step(made)


@pytest.mark.parametrize('which', [kelpie.UPENN_LEFT, kelpie.UPENN_RIGHT, kelpie.HEAD_SWIPE_LEFT])
@pytest.mark.parametrize('off_ahead, off_left, kicks', [
    (1.7, 0.0, True), (-1.7, 0.0, True), (1.9, 0.0, False), (-1.9, 0.0, False), (0.0, 2.1, True),
    (0.0, -2.1, True), (0.0, 2.3, False), (0.0, -2.3, False)])
def test_a_kick_begins_with_the_ball_within_1_8_cm_ahead_and_2_2_aside_of_its_place(
        which, off_ahead, off_left, kicks):
    skill, _ = kicking(which, off_ahead, off_left)
    assert (skill.state == skill.kick) is kicks is skill.committed


@pytest.mark.parametrize('off_ahead, off_left, forward, left', [
    (5.0, 0.0, 13.0, 0.0), (8.0, 0.0, 20.8, 0.0), (-3.0, 0.0, -7.8, 0.0), (10.0, 0.0, 24.0, 0.0),
    (0.0, 3.0, 0.0, 7.8), (0.0, -3.0, 0.0, -7.8), (5.0, 8.0, 13.0, 16.0), (5.0, -8.0, 13.0, -16.0),
    (3.0, 5.0, 0.0, 13.0), (3.0, -5.0, 0.0, -13.0), (3.0, 4.0, 7.8, 10.4), (-3.0, 5.0, -7.8, 13.0)])
def test_the_last_steps_to_a_kick_go_to_both_axes_at_once_by_2_6_of_the_way(off_ahead, off_left,
                                                                          forward, left):
    """Sideways first where the ball would be run over: 4.4 cm aside and less than 4 ahead."""
    _, command = kicking(off_ahead=off_ahead, off_left=off_left)
    assert numbers(command.walk) == pytest.approx((forward, left, 0.0))


@pytest.mark.parametrize('seconds, done', [(6.9, False), (7.1, True)])
def test_an_approach_to_a_kick_is_given_up_after_7_s(seconds, done):
    assert kicking(off_ahead=5.0, seconds=seconds)[0].done is done


def test_where_the_ball_will_be_when_the_motion_begins_0_16_s_later():
    """By what the robot walks in a frame of 1/30 s, and by what a rolling ball does."""
    ahead, left = kelpie.KICKS[kelpie.UPENN_LEFT].place
    made, skill = ball_at(-left, ahead), KickBall(Memory(), kelpie.UPENN_LEFT)
    made.odometry.forward, made.odometry.left = 1.0, 0.5
    assert skill.off(made, -left, ahead) == pytest.approx((-4.8, -2.4))
    made.odometry.forward = made.odometry.left = 0.0
    made.ball.velocity.x, made.ball.velocity.y = 30.0, 40.0
    assert skill.off(made, -left, ahead) == pytest.approx((6.4, -4.8), abs=0.3)


def test_a_short_frame_is_taken_for_0_02_s():
    made, skill = ball_at(0.0, 12.0), KickBall(Memory(), kelpie.UPENN_LEFT)
    made.odometry.forward, made.elapsed_s = 1.0, 0.001
    ahead, _ = kelpie.KICKS[kelpie.UPENN_LEFT].place
    assert skill.off(made, 0.0, 12.0)[0] == pytest.approx(12.0 - 8.0 - ahead)


@pytest.mark.parametrize('which', [kelpie.UPENN_LEFT, kelpie.HEAD_SWIPE_RIGHT])
def test_a_kick_leaves_the_hint_of_its_own_file(which):
    skill, _ = kicking(which)
    made = ball_at(0.0, 12.0)
    made.time_s = 2.0
    for _ in range(3):
        skill.step(made)
    assert skill.done and skill.hint == kelpie.KICKS[which].hint


def test_a_kick_without_a_hint_sends_the_ball_50_cm_ahead():
    skill, made = KickBall(Memory(), kelpie.KICK_FORWARD), ball_at(0.0, 12.0)
    assert kelpie.KICKS[kelpie.KICK_FORWARD].hint is None
    skill.enter(made, skill.kick, SimpleNamespace(step=lambda one: kelpie.NO_MOTION, done=True))
    skill.kick(made)
    assert skill.hint == (50.0, 0.0)
