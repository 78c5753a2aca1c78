# SPDX-License-Identifier: Apache-2.0
import pytest
import kelpie
from situation.goal import Goal, OpponentGoal
from situation.memory import Memory
from skills.ball.go_to_ball import GoToBall, behind
from skills.ball.line_up import CircleBall, aim_error
from skills.ball.line_up_kick import LineUpKick
from skills.ball.strike import StepToKick, Strike
from skills.motion.kick import Kick


def world_with_ball(x, y):
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.ball.present = True
    world.ball.relative.x, world.ball.relative.y = x, y
    world.ball.distance = (x * x + y * y) ** 0.5
    return world


def test_place_behind_the_ball_lies_on_the_line_from_the_goal():
    assert behind((0.0, 100.0), (0.0, 300.0)) == pytest.approx((0.0, 78.0))


def test_walk_to_a_ball_on_the_left_turns_left():
    walk = GoToBall().step(world_with_ball(-50, 100), None)
    assert walk.turn_deg > 0 and walk.forward > 0


def test_ball_behind_is_turned_to_on_the_spot():
    walk = GoToBall().step(world_with_ball(10, -60), None)
    assert walk.forward == 0 and abs(walk.turn_deg) > 30


def test_goal_to_the_left_of_the_ball_is_lined_up_by_stepping_right():
    world = world_with_ball(0, 20)
    goal_point = (-100.0, 120.0)
    assert aim_error((0, 20), goal_point) == pytest.approx(45.0)
    walk = CircleBall().step(world, goal_point)
    assert walk.left < 0 and walk.turn_deg > 0


def test_a_lateral_ball_is_not_approached_further_until_it_is_centred():
    world = world_with_ball(6, Strike.STAND_OFF)
    walk = StepToKick().step(world, (6.0, 200.0))
    assert walk.forward == pytest.approx(0) and walk.left < 0


@pytest.mark.parametrize('x, y, can', [(0, 14.0, True), (2.0, 14.0, False),
                                        (0, 15.6, False), (0, 12.0, False)])
def test_kick_zone(x, y, can):
    world = world_with_ball(x, y)
    assert StepToKick().can_kick(world, (0.0, 200.0)) is can


def test_no_kick_past_the_goal():
    world = world_with_ball(0, 14.0)
    assert not StepToKick().can_kick(world, (100.0, 200.0))


def test_kick_is_requested_until_it_runs_and_ends_with_it():
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    kick = Kick(world)
    assert kick.step(world) == kelpie.KICK_FORWARD
    world.motion.running = kelpie.KICK_FORWARD
    assert kick.step(world) == kelpie.NO_MOTION and not kick.done
    world.motion.running = kelpie.NO_MOTION
    assert kick.step(world) == kelpie.NO_MOTION and kick.done


@pytest.mark.parametrize('waited_s, done', [(1.4, False), (1.6, True)])
def test_a_kick_that_does_not_start_within_a_second_and_a_half_is_given_up(waited_s, done):
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    kick = Kick(world)
    world.time_s += waited_s
    kick.step(world)
    assert kick.done is done


@pytest.mark.parametrize('team, kind', [(kelpie.RED, kelpie.GOAL_BLUE),
                                        (kelpie.BLUE, kelpie.GOAL_YELLOW)])
def test_only_the_opponents_goal_is_shot_at(team, kind):
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'], heading_sd_deg=180.0)
    world.game.team = team
    other = kelpie.GOAL_BLUE + kelpie.GOAL_YELLOW - kind
    goal = OpponentGoal()
    world.percepts.landmarks = [kelpie.LandmarkPercept(kind=other, distance=200.0)]
    goal.update(world)
    assert goal.where(world) is None
    world.percepts.landmarks = [kelpie.LandmarkPercept(kind=kind, distance=200.0)]
    goal.update(world)
    assert goal.where(world) == pytest.approx((0.0, 200.0))


def aim_from(x, y):
    """The heading from a ball there to the point to shoot at, for a robot facing up-field."""
    world = world_with_ball(0.0, 20.0)
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = x, y - 20.0, 90.0
    world.ball.position.x, world.ball.position.y = x, y
    return aim_error((0.0, 20.0), OpponentGoal().where(world))


def test_ball_on_the_goal_line_is_shot_at_the_back_wall_and_not_along_the_line():
    assert aim_from(203.0, 540.0) == pytest.approx(37.5, abs=0.1)  # 23 cm to the side, 30 deep


def test_ball_beside_the_goal_is_shot_at_the_middle_of_the_mouth():
    assert aim_from(280.0, 540.0) == pytest.approx(90.0)


def test_seen_goal_is_carried_along_and_then_forgotten():
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'], heading_sd_deg=180.0)
    world.percepts.landmarks = [kelpie.LandmarkPercept(kind=kelpie.GOAL_BLUE, distance=200.0)]
    goal = OpponentGoal()
    goal.update(world)
    world.percepts.landmarks = []
    world.odometry.turn_deg = 90.0
    goal.update(world)
    assert goal.where(world) == pytest.approx((200.0, 0.0))
    world.time_s += Goal.FRESH + 0.1
    assert goal.where(world) is None


def test_a_ball_that_vanishes_in_the_last_steps_ends_them_without_a_circle():
    world = world_with_ball(0.0, 18.0)
    goal = OpponentGoal()
    goal.point, skill = (0.0, 240.0), LineUpKick(Memory(), goal)
    states = set()
    for frame in range(120):
        world.time_s += 1.0 / 30.0
        goal.seen_s = world.time_s
        world.ball.seconds_since_seen = max(0, frame - 10) / 30
        skill.step(world)
        states.add(skill.state.__name__)
    assert 'strike' in states and skill.state == skill.line_up
