# SPDX-License-Identifier: Apache-2.0
"""The kick of a held ball by the rules of thesis 2006, algorithms 6.8 to 6.11, in their order."""
from types import SimpleNamespace

import kelpie
import pytest
from decisions import kick_choice as choice
from decisions.held_choice import HeldChoice
from decisions.kick_choice import Hold
from situation.contested import Contested
from situation.memory import Memory
from situations import world

HARD, WEDGE = kelpie.HARD_FORWARD, kelpie.WEDGE


def hold(y, x=180.0, contested=False, gap=None, aimed=False, goal_lost=0, goal_heading=40.0,
         own_goal_lost=100, spun=0, side=1.0):
    memory = Memory()
    memory.goal_lost, memory.goal_heading = goal_lost, goal_heading
    memory.own_goal_lost = own_goal_lost
    return Hold(world(x, y), memory, contested, gap, aimed, spun, side)


def kick(*where, **facts):
    return choice.by_rules(hold(*where, **facts))[0]


def test_in_the_own_third_a_visible_own_goal_forbids_the_kick():
    assert kick(100) == HARD
    assert kick(100, own_goal_lost=0) == choice.SPIN_AWAY


def test_midfield_is_as_the_own_third_but_soft_when_contested():
    assert kick(270) == HARD and kick(270, contested=True) == WEDGE
    assert kick(270, own_goal_lost=0) == choice.SPIN_AWAY


@pytest.mark.parametrize('facts, wanted', [
    (dict(x=40.0, gap=(5.0, -5.0), aimed=True), choice.PASS_RIGHT),
    (dict(x=320.0, gap=(5.0, -5.0), aimed=True), choice.PASS_LEFT),
    (dict(x=40.0, gap=(8.0, -8.0), aimed=True), HARD),
    (dict(gap=(8.0, -8.0), aimed=True), HARD),
    (dict(goal_heading=14.9), HARD),
    (dict(goal_heading=-15.0), WEDGE)])
def test_a_goal_in_sight(facts, wanted):
    assert kick(480, **facts) == wanted


@pytest.mark.parametrize('x, gap, passes', [
    (78.0, (5.0, -5.0), True), (82.0, (5.0, -5.0), False), (180.0, (5.0, -5.0), False),
    (40.0, (5.9, -5.9), True), (40.0, (6.1, -6.1), False), (282.0, (5.0, -5.0), True),
    (278.0, (5.0, -5.0), False)])
@pytest.mark.parametrize('frames', [0, 10])
def test_within_1_m_of_a_corner_a_gap_under_12_degrees_is_passed_across(x, gap, passes, frames):
    found = kick(480.0, x=x, gap=gap, aimed=True, goal_lost=frames)
    assert (found in (choice.PASS_LEFT, choice.PASS_RIGHT)) is passes


@pytest.mark.parametrize('frames, turns', [(4, True), (5, False)])
def test_an_own_goal_seen_fewer_than_5_frames_ago_forbids_the_kick(frames, turns):
    for y in (100.0, 270.0):
        assert (kick(y, own_goal_lost=frames) == choice.SPIN_AWAY) is turns


@pytest.mark.parametrize('y, wanted', [
    (489, WEDGE), (491, HARD), (509, HARD), (511, choice.RELEASE)])
def test_near_a_goal_that_is_to_the_side(y, wanted):
    """Closer than 30 cm comes before the last 50 cm, as listed (G47)."""
    assert kick(y) == wanted


@pytest.mark.parametrize('frames, seen_lately', [(1, True), (14, True), (15, False)])
def test_a_goal_seen_fewer_than_15_frames_ago_is_still_shot_at(frames, seen_lately):
    assert kick(495, goal_lost=frames) == (HARD if seen_lately else WEDGE)
    assert kick(480, goal_lost=frames) == WEDGE


@pytest.mark.parametrize('facts, wanted', [
    (dict(y=351.0, spun=30, side=-1.0), kelpie.HEAD_SWIPE_RIGHT),
    (dict(y=351.0, spun=30, side=1.0), kelpie.HEAD_SWIPE_LEFT),
    (dict(y=351.0, spun=29), WEDGE),
    (dict(y=350.0, spun=30), WEDGE),
    (dict(y=351.0, spun=30, own_goal_lost=0), WEDGE)])
def test_without_sight_of_the_goal_a_long_turn_ends_in_a_swipe_on_its_side(facts, wanted):
    assert choice.goal_not_seen(hold(goal_lost=100, **facts))[0] == wanted


def test_without_sight_of_the_goal_the_ball_is_let_go_in_the_own_half():
    assert choice.goal_not_seen(hold(269.0, goal_lost=100))[0] == choice.RELEASE


def test_out_of_time_it_kicks_without_sight_of_the_goal_but_never_at_its_own():
    assert choice.out_of_time(hold(400, goal_lost=100))[0] == WEDGE
    assert choice.out_of_time(hold(100, own_goal_lost=0))[0] == choice.RELEASE


def test_the_kick_is_no_stronger_the_less_is_known_of_the_goal():
    """Section 6.4.7; the kick's own file says how far it sends a ball."""
    far = [kelpie.KICKS[kick(495, **facts)].distance for facts in (
        dict(gap=(20.0, -20.0), aimed=True), dict(goal_lost=10), dict(goal_lost=100))]
    assert far == sorted(far, reverse=True) and far[0] > far[-1]


def test_the_last_half_metre_is_told_in_cm():
    assert choice.by_rules(hold(495.0))[1:] == ('{} cm before the goal line', 45.0)


def test_every_choice_says_why_within_a_trace():
    for y in range(0, 540, 7):
        for lost in (0, 10, 100):
            for facts in (dict(), dict(x=20.0, gap=(3.0, -3.0)), dict(contested=True),
                          dict(gap=(9.0, -9.0), aimed=True), dict(own_goal_lost=0, spun=40)):
                _, reason, *numbers = choice.by_rules(hold(y, goal_lost=lost, **facts))
                assert 0 < len(reason) <= 80 and reason.count('{}') == len(numbers)


@pytest.mark.parametrize('plan, inside, wanted', [
    ('grab_dribble_stop', 44.0, None), ('grab_dribble_stop', 46.0, choice.RELEASE),
    ('grab_upenn_left', 10.0, kelpie.UPENN_LEFT), ('grab_upenn_right', 10.0, kelpie.UPENN_RIGHT)])
def test_a_ball_carried_back_is_let_go_45_cm_inside_and_one_at_an_edge_is_struck(plan, inside,
                                                                                 wanted):
    made = world()
    made.task.kicks = kelpie.KICKS_BY_RULES
    dribble = SimpleNamespace(plan=plan, line_distance=lambda world: inside)
    found = HeldChoice(Memory(), Contested()).choose(made, dribble, False)
    assert (found[0] if found is not None else None) == wanted


@pytest.mark.parametrize('aimed, carries, kicks', [
    (True, False, True), (True, True, False), (False, False, False), (False, True, False)])
def test_who_has_aimed_kicks_unless_carrying_the_ball_on_helps(aimed, carries, kicks):
    made = world()
    made.task.kicks = kelpie.KICKS_BY_RULES
    dribble = SimpleNamespace(plan='grab_turn_shoot', searched=0, search_side=1.0,
                              aim=SimpleNamespace(gap=(10.0, -10.0), aimed=aimed,
                                                  points_into_gap=aimed),
                              should_carry=lambda world: carries)
    found = HeldChoice(Memory(), Contested()).choose(made, dribble, False)
    assert (found is not None) is kicks
