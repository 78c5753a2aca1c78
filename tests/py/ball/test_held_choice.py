# SPDX-License-Identifier: Apache-2.0
"""Which choice decides on a held ball: the map, the plan of the leaf, or the rules of thesis 2006
section 6.4.7; and that nobody kicks at an own goal in sight."""
from types import SimpleNamespace

import kelpie
import pytest
from decisions import held_choice, passing
from decisions.held_choice import HeldChoice
from decisions.kick_choice import RELEASE
from lib import kick_table
from situation.memory import Memory
from situations import world

RULES, MAP = kelpie.KICKS_BY_RULES, kelpie.KICKS_BY_MAP


def asked(plan='grab_turn_shoot', kicks=RULES, gap=(8.0, -8.0), aimed=True, overdue=False, y=300.0,
          searched=0, carries=False, **memory):
    """The choice of who looks up-field at a goal that it sees straight ahead."""
    made, known = world(180.0, y, 90.0), Memory()
    made.task.kicks = kicks
    known.goal_lost = 0
    for name, value in memory.items():
        setattr(known, name, value)
    aim = SimpleNamespace(gap=gap, aimed=aimed, points_into_gap=True)
    dribble = SimpleNamespace(aim=aim, plan=plan, searched=searched, search_side=1.0,
                              standing=False, should_carry=lambda one: carries)
    choice = HeldChoice(known, SimpleNamespace(now=False))
    return choice.choose(made, dribble, overdue), choice


@pytest.mark.parametrize('plan, kick', [('grab_upenn_left', kelpie.UPENN_LEFT),
                                        ('grab_upenn_right', kelpie.UPENN_RIGHT)])
def test_a_plan_to_strike_back_in_is_struck_at_once_by_the_rules_and_left_to_the_map(plan, kick):
    assert asked(plan, aimed=False)[0][0] == kick
    assert asked(plan, MAP, aimed=False)[0] != (kick, 'struck back into the field at once')


@pytest.mark.parametrize('aimed, carries, kicks', [(True, False, True), (False, False, False),
                                                   (True, True, False)])
def test_by_the_rules_who_has_aimed_and_need_not_carry_kicks(aimed, carries, kicks):
    found = asked(aimed=aimed, carries=carries)[0]
    assert (found is not None) is kicks
    assert not kicks or found[0] == kelpie.HARD_FORWARD


@pytest.mark.parametrize('gap, searched, kicks', [(None, 30, True), (None, 29, False),
                                                  ((8.0, -8.0), 30, False)])
def test_by_the_rules_who_turned_30_frames_and_saw_no_goal_kicks(gap, searched, kicks):
    found = asked(gap=gap, aimed=False, searched=searched, y=400.0, goal_lost=100)[0]
    assert (found is not None) is kicks


def test_out_of_time_the_rules_kick_without_an_aim():
    assert asked(aimed=False, overdue=True)[0][0] == kelpie.HARD_FORWARD


@pytest.mark.parametrize('posts, kicks', [((10.0, -10.0), False), ((90.0, 60.0), True),
                                          ((-60.0, -90.0), True), ((-10.0, -40.0), False)])
def test_nobody_kicks_at_an_own_goal_that_he_sees(posts, kicks):
    """A kick goes straight ahead; within 15 deg of the posts it is spared."""
    found, choice = asked(own_goal_lost=14, own_goal=posts)
    assert (found is not None) is kicks and choice.pass_to == 0
    late = asked(own_goal_lost=14, own_goal=posts, overdue=True)[0]
    assert (late[0] == RELEASE) is not kicks


def test_a_ball_that_is_let_go_may_be_let_go_before_the_own_goal():
    assert held_choice.way_of(RELEASE) == held_choice.NOWHERE
    assert held_choice.way_of(kelpie.HARD_FORWARD) == pytest.approx(0.0, abs=15.0)


@pytest.mark.parametrize('gap, middle', [((30.0, 10.0), 20.0), (None, 0.0)])
def test_a_pass_is_weighed_against_the_own_kick_at_the_middle_of_the_gap(monkeypatch, gap, middle):
    turns = []
    monkeypatch.setattr(passing, 'best', lambda *one: (0.9, kelpie.WEDGE, 3))
    monkeypatch.setattr(held_choice, 'mouth', lambda one: None)
    monkeypatch.setattr(held_choice.kick_map_choice, 'utility_of',
                        lambda one, kick, free, turn: turns.append((free, turn)) or 0.1)
    choice = HeldChoice(Memory(), SimpleNamespace(now=False))
    dribble = SimpleNamespace(aim=SimpleNamespace(gap=gap))
    assert choice.pass_to == 0
    assert choice.pass_on(world(), dribble)[0] == kelpie.WEDGE and choice.pass_to == 3
    assert set(turns) == {(gap, middle)}
    choice.start()
    assert choice.pass_to == 0


@pytest.mark.parametrize('heading, into, kick', [
    (20.0, True, kelpie.HARD_FORWARD), (20.0, False, kelpie.WEDGE), (10.0, False,
                                                                     kelpie.HARD_FORWARD)])
def test_before_a_goal_that_is_seen_it_is_kicked_hard_into_the_gap_or_within_15_deg(heading, into,
                                                                                  kick):
    """Algorithm 6.9."""
    made, known = world(180.0, 400.0, 90.0), Memory()
    made.task.kicks, known.goal_lost, known.goal_heading = RULES, 0, heading
    aim = SimpleNamespace(gap=(30.0, 10.0), aimed=True, points_into_gap=into)
    dribble = SimpleNamespace(aim=aim, plan='grab_turn_shoot', searched=0, search_side=1.0,
                              should_carry=lambda one: False)
    choice = HeldChoice(known, SimpleNamespace(now=False))
    assert choice.choose(made, dribble, False)[0] == kick


@pytest.mark.parametrize('chosen, motion', [('pass_left', kelpie.UPENN_LEFT),
                                            ('pass_right', kelpie.UPENN_RIGHT),
                                            (kelpie.WEDGE, kelpie.WEDGE)])
def test_a_pass_across_is_a_upenn_kick_to_that_side_for_the_same_reason(chosen, motion):
    assert held_choice.as_motion((chosen, 'why {}', 3.0)) == (motion, 'why {}', 3.0)


@pytest.mark.parametrize('kick', [kelpie.UPENN_LEFT, kelpie.UPENN_RIGHT, kelpie.WEDGE])
def test_the_way_of_a_kick_is_that_from_the_hold(kick):
    assert held_choice.way_of(kick) == kick_table.held_outcome(kick)[1]


@pytest.mark.parametrize('mates, passing_on, passes', [(1, True, True), (0, True, False),
                                                       (1, False, False)])
def test_a_pass_is_thought_of_with_mates_where_that_is_on(mates, passing_on, passes):
    made, choice = world(), HeldChoice(Memory(), SimpleNamespace(now=False))
    made.task.passing, made.teammates = passing_on, [kelpie.TeammateEstimate()] * mates
    choice.pass_on = lambda one, two: ('a pass',)
    choice.alone = lambda one, two, three: ('alone',)
    choice.pass_to = 4
    assert choice.by_pose(made, None, False) == (('a pass',) if passes else ('alone',))
    assert choice.pass_to == (4 if passes else 0)
