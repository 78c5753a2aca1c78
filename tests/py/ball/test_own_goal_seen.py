# SPDX-License-Identifier: Apache-2.0
"""Nobody kicks at an own goal that he sees (thesis 2006 Alg 6.8), also where the pose is wrong by
half a turn and says that it is the opponents'."""
import kelpie
import pytest
from decisions import kick_choice
from decisions.held_choice import HeldChoice, way_of
from lib import kick_table
from situation.aim import Aim
from situation.contested import Contested
from situation.goal import OpponentGoal
from situation.memory import OWN_GOAL_KEPT, Memory, own_goal_at
from situations import put_ball, world
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold
from skills.ball.kick_ball import KickBall
from skills.ball.line_up_kick import LineUpKick
from skills.ball.strike import StepToKick, Strike

RULES = kelpie.KICKS_BY_MAP, kelpie.KICKS_BY_RULES


def seeing(made, heading, kind=kelpie.GOAL_YELLOW, wide=30.0):
    """The same with a goal in its percepts; red's own is yellow."""
    made.percepts.landmarks = [kelpie.LandmarkPercept(
        kind=kind, distance=200.0, heading_deg=heading, left_edge_deg=heading + 0.5 * wide,
        right_edge_deg=heading - 0.5 * wide)]
    return made


def wrong_by_half_a_turn(kicks=kelpie.KICKS_BY_MAP, **place):
    """Where it believes to hold the ball before the opponents' goal, and looks at its own."""
    made = world(180.0, 490.0, 90.0, **place)
    made.task.kicks = kicks
    return made


def held(made, overdue, frames=8):
    memory = Memory()
    dribble = GrabDribble(memory, None)
    dribble.hold, dribble.aim = Hold(made, made.time_s), Aim()
    for _ in range(frames):   # the aim counts frames
        memory.update(made)
        dribble.aim.update(made)
    return HeldChoice(memory, Contested()).choose(made, dribble, overdue)


@pytest.mark.parametrize('kicks', RULES)
@pytest.mark.parametrize('aside', (-10.0, 0.0, 10.0))
def test_a_held_ball_is_not_kicked_at_an_own_goal_in_sight(kicks, aside):
    assert held(seeing(wrong_by_half_a_turn(kicks), aside), overdue=False) is None


@pytest.mark.parametrize('kicks', RULES)
def test_out_of_time_it_is_let_go_or_kicked_past_it(kicks):
    chosen = held(seeing(wrong_by_half_a_turn(kicks), 0.0), overdue=True)[0]
    assert chosen == kick_choice.RELEASE or abs(way_of(chosen)) > 30.0


@pytest.mark.parametrize('kicks', RULES)
def test_the_opponents_goal_at_the_same_place_is_kicked_at(kicks):
    chosen = held(seeing(wrong_by_half_a_turn(kicks), 0.0, kelpie.GOAL_BLUE), overdue=False)
    assert chosen[0] in kelpie.KICKS


def test_an_own_goal_beside_the_way_of_the_ball_forbids_nothing():
    assert held(seeing(wrong_by_half_a_turn(), 90.0), overdue=False) is not None


def free(made, which=kelpie.HEAD_SWIPE_LEFT):
    """What becomes of a kick of a free ball that lies where it should."""
    memory = Memory()
    memory.update(made)
    skill = KickBall(memory, which)
    for _ in range(3):
        skill.step(made)
    return skill


@pytest.mark.parametrize('which', (kelpie.HEAD_SWIPE_LEFT, kelpie.UPENN_RIGHT))
def test_a_free_ball_is_not_kicked_at_an_own_goal_in_sight(which):
    way = kick_table.window_outcome(which)[1]
    ahead, left = kelpie.KICKS[which].place
    made = wrong_by_half_a_turn()
    put_ball(made, 180.0 - left, 490.0 + ahead)
    skill = free(seeing(made, way), which)
    assert skill.done and not skill.committed
    made.percepts.landmarks = []
    assert free(made, which).committed


def test_who_has_lined_up_does_not_kick_at_it_either():
    made = wrong_by_half_a_turn(ball=(180.0, 490.0 + Strike.KICK_AHEAD))
    goal, memory = OpponentGoal(), Memory()
    for shown, kicks in ((kelpie.GOAL_YELLOW, False), (kelpie.GOAL_BLUE, True)):
        seeing(made, 0.0, shown)
        memory.own_goal_lost = OWN_GOAL_KEPT
        memory.update(made)
        goal.update(made)
        skill = LineUpKick(memory, goal)
        skill.enter(made, skill.strike, StepToKick(), 'to strike')
        skill.step(made)
        assert (skill.state == skill.kick) == kicks


def test_it_is_carried_along_by_the_turn_for_half_a_second():
    made, memory = seeing(world(), 40.0), Memory()
    memory.update(made)
    made.percepts.landmarks, made.odometry.turn_deg = [], 5.0
    for _ in range(8):
        memory.update(made)
    assert own_goal_at(memory, 0.0) and not own_goal_at(memory, 40.0)
    for _ in range(OWN_GOAL_KEPT):
        memory.update(made)
    assert not any(own_goal_at(memory, direction) for direction in range(-180, 180, 10))
