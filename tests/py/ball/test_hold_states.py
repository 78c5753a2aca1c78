# SPDX-License-Identifier: Apache-2.0
"""A held ball from state to state: what ends the turn, when it is turned on past the pose's goal,
who is gone round, what a search begins with, and what is left of a kick."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from decisions.kick_choice import RELEASE
from situation.memory import Memory
from situations import world
from skills.ball.grab_dribble import GrabDribble, lines_from
from skills.ball.hold import Hold
from skills.head.track_ball import by_projection
from skills.walk.go_to_point import GoToPoint

KICK = (kelpie.HARD_FORWARD, 'told to')


def turning(y=300.0, heading=90.0, choice=None, plan='grab_dribble_goal', rules=0):
    """It turns with the ball; `choice`: of a kick before time is out, and after."""
    made = world(180.0, y, heading)
    made.task.rules = rules
    made.heading_sd_deg, made.time_s = 60.0, 5.0
    made.motion.feeling.ball_held = True
    skill = GrabDribble(Memory(), lambda one, two, overdue: choice, plan)
    skill.hold = Hold(made, 4.9)
    skill.enter(made, skill.turn)
    return made, skill


def aimed(skill, middle=0.0, frames=4, by_sight=True):
    """Its aim is at a gap about that middle, for so many frames."""
    skill.aim = SimpleNamespace(gap=(middle + 8.0, middle - 8.0), middle=middle, by_sight=by_sight,
                                aimed=frames >= 4, update=lambda made: None)


def test_a_choice_stops_the_turn_and_is_asked_again_after_the_stop():
    made, skill = turning(choice=KICK)
    skill.step(made)
    assert skill.standing
    made.time_s += 0.2
    skill.step(made)
    assert skill.state == skill.kick
    made, skill = turning(choice=None)
    skill.enter(made, skill.steady)
    made.time_s += 0.2
    skill.step(made)
    assert skill.state == skill.turn


@pytest.mark.parametrize('y, by_sight, over, turns', [
    (199.0, False, 0, True), (201.0, False, 0, False), (199.0, True, 0, False),
    (199.0, False, 7, True), (199.0, False, 8, False)])
@pytest.mark.parametrize('side', [1.0, -1.0])
def test_a_goal_that_the_pose_faces_and_nobody_sees_is_turned_on_for_in_8_frames(y, by_sight, over,
                                                                               turns, side):
    made, skill = turning(y, choice=KICK)
    aimed(skill, by_sight=by_sight)
    skill.over_turned, skill.turn_side = over, side
    skill.enter(made, skill.turn)
    skill.turn(made)
    assert (skill.state == skill.over_turn) is turns
    command = skill.over_turn(made)
    assert (command is not None and command.walk.turn_deg == side * 50.0) is turns
    assert skill.over_turned == (over + 1 if turns else over)


@pytest.mark.parametrize('middle, dodged, dodges', [
    (29.0, False, True), (-29.0, False, True), (31.0, False, False), (-31.0, False, False),
    (0.0, True, False)])
def test_who_stands_in_the_way_is_gone_round_once_looking_30_deg_at_the_gap(middle, dodged, dodges):
    made, skill = turning()
    made.sensors.head_near_distance = 10.0
    aimed(skill, middle, frames=0)
    skill.skill = SimpleNamespace() if dodged else None
    skill.turn(made)
    assert (skill.state == skill.dodge) is dodges
    made.task.dodge = False
    skill.enter(made, skill.turn)
    skill.turn(made)
    assert skill.state == skill.turn


@pytest.mark.parametrize('frames, y, carries', [(4, 400.0, True), (0, 400.0, False),
                                                (4, 520.0, False)])
def test_aimed_and_from_where_that_helps_the_ball_is_carried_on(frames, y, carries):
    made, skill = turning(y)
    aimed(skill, frames=frames)
    skill.turn(made)
    assert (skill.state == skill.carry_on) is carries


@pytest.mark.parametrize('middle, side', [(10.0, 1.0), (-10.0, -1.0)])
def test_the_side_of_a_turn_to_the_gap_is_remembered(middle, side):
    made, skill = turning()
    aimed(skill, middle, frames=0)
    command = skill.turn(made)
    assert command.walk.turn_deg == pytest.approx(40.0 * side) and skill.turn_side == side


def test_carrying_on_ends_where_the_gap_is_lost_and_in_who_stands_there():
    made, skill = turning(400.0)
    aimed(skill)
    made.sensors.head_near_distance = 10.0
    skill.enter(made, skill.carry_on)
    skill.carry_on(made)
    assert skill.state == skill.dodge
    skill.enter(made, skill.carry_on)
    skill.aim.gap = None
    skill.carry_on(made)
    assert skill.state == skill.turn


@pytest.mark.parametrize('heading, side', [(0.0, 1.0), (180.0, -1.0), (90.0, 1.0)])
def test_the_search_turn_counts_its_frames_and_keeps_the_side_that_it_began_to(heading, side):
    made, skill = turning(heading=heading)
    speeds = [skill.search_turn(made).walk.turn_deg for _ in range(2)]
    made.pose.heading_deg = 360.0 - heading
    speeds.append(skill.search_turn(made).walk.turn_deg)
    assert speeds == [side * 100.0] * 3 and skill.searched == 3


@pytest.mark.parametrize('lost, by_sight, ready, turns', [
    (4, False, True, True), (5, False, True, False), (4, True, True, False),
    (4, False, False, False)])
@pytest.mark.parametrize('posts, side', [((30.0, 10.0), -1.0), ((-10.0, -30.0), 1.0)])
def test_by_the_theses_it_spins_away_from_an_own_goal_that_it_aimed_at(lost, by_sight, ready, turns,
                                                                      posts, side):
    made, skill = turning(rules=kelpie.RULES_OF_THESIS)
    aimed(skill, frames=4 if ready else 0, by_sight=by_sight)
    skill.memory.own_goal_lost, skill.memory.own_goal = lost, posts
    skill.turn(made)
    assert (skill.state == skill.spin_away) is turns
    if turns:
        assert skill.search_side == side and skill.searched == 1
        skill.aim.by_sight = False
        command = skill.spin_away(made)
        assert command.walk.turn_deg == side * 50.0 and skill.searched == 2


@pytest.mark.parametrize('what, near, steps', [
    (KICK, False, False), (KICK, True, True), ((RELEASE, 'let go'), False, True)])
def test_a_ball_let_go_or_kicked_at_somebody_is_left_lying(what, near, steps):
    made, skill = turning()
    made.sensors.head_near_distance = 19.0 if near else 21.0
    skill.fire(made, what)
    assert skill.steps_back is steps
    skill.leave(made, 'done')
    assert (skill.hint == (25.0, 0.0)) is steps
    assert skill.state == (skill.step_back if steps else skill.ended)


@pytest.mark.parametrize('x, y, lines', [
    (180.0, 300.0, (180.0, 180.0, 308.0, math.inf)), (100.0, 300.0, (100.0, 260.0, 308.0, 232.0)),
    (141.0, 500.0, (141.0, 219.0, 508.0, math.inf)), (139.0, 500.0, (139.0, 221.0, 508.0, 32.0))])
def test_the_lines_are_counted_from_the_ball_8_cm_ahead_and_a_goals_mouth_is_none(x, y, lines):
    assert lines_from(world(x, y, 90.0)) == pytest.approx(lines)


@pytest.mark.parametrize('x, y, heading, way', [
    (10.0, 300.0, 90.0, (0.0, -1.0)), (350.0, 300.0, 90.0, (0.0, 1.0)),
    (180.0, 10.0, 0.0, (0.0, 1.0)), (60.0, 525.0, 90.0, (-1.0, 0.0)),
    (180.0, 300.0, 90.0, (0.0, 0.0)),
    (10.0, 525.0, 90.0, (-0.7071, -0.7071)), (350.0, 10.0, 90.0, (0.7071, 0.7071))])
def test_the_way_in_is_square_away_from_the_lines_that_are_near(x, y, heading, way):
    """Ahead and left of the robot."""
    made, skill = turning()
    made.pose.position.x, made.pose.position.y, made.pose.heading_deg = x, y, heading
    assert skill.way_in(made) == pytest.approx(way, abs=0.001)


@pytest.mark.parametrize('x, y, away', [(180.0, 300.0, 240.0), (140.0, 510.0, 50.0)])
def test_the_goal_is_as_far_as_its_middle(x, y, away):
    made, skill = turning()
    made.pose.position.x, made.pose.position.y = x, y
    assert skill.goal_distance(made) == pytest.approx(away)


# Two that hold no ball

@pytest.mark.parametrize('y, radius, seen', [(20.0, 19.5, True), (20.0, 20.5, False)])
def test_a_ball_whose_top_is_out_of_the_image_cannot_be_projected(y, radius, seen):
    made = world()
    made.head.neck_tilt_deg, ball = -40.0, made.percepts.ball
    ball.present, ball.centre.x, ball.centre.y, ball.radius = True, 104.0, y, radius
    assert (by_projection(ball, made) is not None) is seen
    ball.present = False
    assert by_projection(ball, made) is None


def test_a_walk_to_a_point_begins_with_a_turn_until_it_is_6_deg_off():
    for off, turns in ((7.0, True), (5.0, False)):
        skill = GoToPoint((180.0, 300.0), 3.0)
        walk = skill.walk_there(world(180.0, 200.0, 90.0 + off))
        assert (walk.forward == 0.0) is turns
