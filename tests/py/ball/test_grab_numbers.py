# SPDX-License-Identifier: Apache-2.0
"""The numbers of a grab, of the kick that is lined up in its place, and of the map's choice of a
kick from the hold."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from decisions import kick_map_choice
from lib import kick_table
from situation.goal import OpponentGoal
from situation.memory import Memory
from situations import world
from skills.ball.grab import Grab, approach, can_grab, limited, walk_kind
from skills.ball.line_up_kick import LineUpKick

SLOW, FAST, TURNING = kelpie.WALK, kelpie.WALK_FAST, kelpie.WALK_TURNING


def at(away, degrees):
    angle = math.radians(degrees)
    return -away * math.sin(angle), away * math.cos(angle)


# The approach

@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('away, off_deg, last, kind', [
    (100.0, 49.0, SLOW, SLOW), (100.0, 51.0, SLOW, TURNING), (100.0, 31.0, TURNING, TURNING),
    (100.0, 29.0, TURNING, SLOW), (34.0, 19.0, SLOW, FAST), (32.0, 19.0, SLOW, SLOW),
    (34.0, 21.0, SLOW, SLOW), (34.0, 29.0, FAST, FAST), (34.0, 31.0, FAST, SLOW),
    (32.0, 0.0, FAST, SLOW)])
def test_a_ball_is_turned_to_from_50_deg_until_30_and_run_to_from_33_cm_within_20_until_30(
        side, away, off_deg, last, kind):
    assert walk_kind(away, side * off_deg, last) == kind


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('away, off_deg, forward, turn', [
    (100.0, 0.0, 100.0, 0.0), (40.0, 25.0, 36.0 * math.cos(math.radians(25.0)), 45.0),
    (20.0, 0.0, 31.0, 0.0), (20.0, 40.0, 31.0 * math.cos(math.radians(40.0)), 72.0)])
def test_the_legs_close_with_31_cm_a_second_at_least_and_turn_twice_as_fast_as_the_thesis(
        side, away, off_deg, forward, turn):
    point = at(away, side * off_deg)
    walk = limited(approach(point, SLOW), side * off_deg, 2.0)
    assert (walk.forward, walk.turn_deg) == pytest.approx((forward, side * turn))
    assert walk.left == 0.0


@pytest.mark.parametrize('off_deg, forward', [(59.0, 31.0 * math.cos(math.radians(59.0))),
                                              (61.0, 10.0 * math.cos(math.radians(61.0)))])
def test_beyond_60_deg_nobody_closes_in(off_deg, forward):
    """A ball 10 cm off, by a walk that may not turn on the spot."""
    request = kelpie.WalkRequest(forward=10.0 * math.cos(math.radians(off_deg)), kind=SLOW)
    assert limited(request, off_deg, 1.0).forward == pytest.approx(forward)


@pytest.mark.parametrize('off_deg, forward', [(70.0, 36.0 * math.cos(math.radians(70.0))),
                                              (85.0, 7.2), (170.0, 7.2)])
def test_far_aside_a_slow_walk_is_a_fifth_at_least_of_36_cm_a_second(off_deg, forward):
    request = kelpie.WalkRequest(forward=90.0, kind=SLOW)
    assert limited(request, off_deg, 1.0).forward == pytest.approx(forward)


@pytest.mark.parametrize('off_deg', [50.0, -50.0, 160.0])
def test_a_turn_on_the_spot_goes_by_three_times_the_angle_and_at_200_at_most(off_deg):
    walk = limited(kelpie.WalkRequest(forward=9.0, kind=TURNING), off_deg, 2.0)
    assert walk.forward == 0.0 and walk.kind == TURNING
    assert walk.turn_deg == pytest.approx(math.copysign(min(3.0 * abs(off_deg), 200.0), off_deg))


@pytest.mark.parametrize('velocity, wanted', [((0.0, 0.0), False), ((0.0, -1.0), True)])
def test_a_ball_that_rolls_in_is_grabbed_before_it_lies_between_the_paws(velocity, wanted):
    assert can_grab((0.0, 15.0), velocity, 100) is wanted


# The grab

def grabbing(seen_s=0.0, ahead=12.0, chest=50.0):
    memory = Memory()
    memory.chest, memory.turn_lost = chest, 100
    made = world(180.0, 200.0, 90.0, (180.0, 200.0 + ahead))
    made.ball.seconds_since_seen = seen_s
    skill = Grab(memory)
    return made, skill, skill.step(made)


@pytest.mark.parametrize('seen_s, grabs', [(0.19, True), (0.21, False)])
def test_only_a_ball_seen_within_0_2_s_is_grabbed(seen_s, grabs):
    _, skill, _ = grabbing(seen_s)
    assert skill.committed is grabs and skill.approached


@pytest.mark.parametrize('chest, motion', [(11.4, kelpie.GRAB_QUICK), (11.6, kelpie.GRAB)])
def test_a_chest_that_reads_less_than_11_5_cm_makes_the_grab_quick(chest, motion):
    _, _, command = grabbing(chest=chest)
    assert command.motion == motion and command.walk.forward == 8.0


@pytest.mark.parametrize('ahead, hinted', [(39.0, True), (41.0, False)])
def test_a_ball_within_40_cm_will_come_out_ahead_if_it_is_lost(ahead, hinted):
    _, skill, _ = grabbing(ahead=ahead)
    assert (skill.hint == (30.0, 0.0)) is hinted


@pytest.mark.parametrize('x, ahead, held', [
    (0.0, 3.1, True), (0.0, 2.9, False), (0.0, 10.9, True), (0.0, 11.1, False), (3.9, 8.0, True),
    (4.1, 8.0, False), (-4.1, 8.0, False)])
def test_a_ball_3_to_11_cm_ahead_and_4_aside_lies_between_the_paws(x, ahead, held):
    made, skill, _ = grabbing(1.0, 100.0)
    made.time_s = 4.0
    skill.watch_paws(made, x, ahead)
    assert skill.inside_s == (4.0 if held else None)
    made.time_s = 5.0
    skill.watch_paws(made, x, ahead)
    assert skill.inside_s == (4.0 if held else None)


@pytest.mark.parametrize('ran, seconds, over', [(False, 0.49, False), (False, 0.51, True),
                                                (True, 1.99, False), (True, 2.01, True)])
def test_a_grab_may_take_0_5_s_to_begin_and_2_in_all(ran, seconds, over):
    made, skill, _ = grabbing()
    made.motion.running = kelpie.GRAB if ran else kelpie.NO_MOTION
    made.time_s += seconds
    command = skill.step(made)
    assert skill.done is over and skill.grabbed
    assert over or command.motion == (kelpie.NO_MOTION if ran else kelpie.GRAB)


@pytest.mark.parametrize('rules, motion, pan', [
    (kelpie.RULES_OF_KELPIE, kelpie.GRAB, 0.0), (kelpie.RULES_OF_THESIS, kelpie.GRAB_LIFT, 5.0)])
def test_by_the_theses_a_grab_lifts_the_head_and_turns_it_to_the_ball(rules, motion, pan):
    made, skill, _ = grabbing()
    made.task.rules, made.ball.heading_deg = rules, 5.0
    command = skill.grab(made)
    assert (command.motion, command.head.head_pan_deg) == (motion, pan)


# Lined up in place of a grab

def lining_up(state, away=20.0, seconds=0.0, seen_ago=0.1, looked_ago=1.0, unseen=0.0, right=0.0):
    """The goal was seen 300 cm ahead, the ball lies ahead; `right`: of the middle."""
    made = world(180.0, 200.0, 90.0, (180.0 + right, 200.0 + away))
    made.time_s, made.ball.seconds_since_seen = 50.0, unseen
    goal = OpponentGoal()
    goal.point, goal.seen_s, goal.looked_s = (0.0, 300.0), 50.0 - seen_ago, 50.0 - looked_ago
    skill = LineUpKick(Memory(), goal)
    made.time_s = 50.0 - seconds
    skill.enter(made, getattr(skill, state), SimpleNamespace(
        step=lambda *asked: kelpie.WalkRequest(), can_kick=lambda *asked: False,
        out_of_reach=lambda *asked: False, done=False))
    made.time_s = 50.0
    return made, skill


@pytest.mark.parametrize('away, seconds, state', [
    (29.0, 0.0, 'approach'), (27.0, 0.0, 'line_up'), (100.0, 24.9, 'approach'),
    (100.0, 25.1, 'ended')])
def test_it_lines_up_from_28_cm_on_and_walks_to_the_ball_for_25_s_at_most(away, seconds, state):
    made, skill = lining_up('approach', away, seconds)
    skill.approach(made)
    assert skill.state.__name__ == state


@pytest.mark.parametrize('facts, state', [
    ({'right': 8.0}, 'line_up'), ({'right': 8.0, 'away': 37.0}, 'line_up'),
    ({'away': 39.0}, 'approach'),
    ({'right': 8.0, 'seconds': 14.9}, 'line_up'), ({'right': 8.0, 'seconds': 15.1}, 'ended'),
    ({'right': 8.0, 'seen_ago': 7.0, 'looked_ago': 11.9}, 'line_up'),
    ({'right': 8.0, 'seen_ago': 7.0, 'looked_ago': 12.1}, 'look_for_goal'),
    ({'right': 8.0, 'seen_ago': 5.0, 'looked_ago': 99.0}, 'line_up'), ({}, 'strike'),
    ({'unseen': 1.6}, 'line_up')])
def test_round_the_ball_it_goes_until_it_is_in_line(facts, state):
    made, skill = lining_up('line_up', **facts)
    skill.line_up(made)
    assert skill.state.__name__ == state


@pytest.mark.parametrize('ball_deg, aim_deg, aligned', [
    (0.0, 9.0, True), (0.0, 11.0, False), (0.0, -9.0, True), (0.0, -11.0, False),
    (14.0, 0.0, True), (16.0, 0.0, False), (-14.0, 0.0, True), (-16.0, 0.0, False)])
def test_in_line_is_within_10_deg_of_the_goal_with_the_ball_15_deg_ahead(ball_deg, aim_deg,
                                                                       aligned):
    made, skill = lining_up('line_up')
    x, y = at(20.0, ball_deg)
    made = world(180.0, 200.0, 90.0, (180.0 + x, 200.0 + y))
    dx, dy = at(100.0, ball_deg + aim_deg)
    assert skill.aligned(made, (x + dx, y + dy)) is aligned
    assert not skill.aligned(made, None)


@pytest.mark.parametrize('state, seconds, after', [
    ('strike', 7.9, 'strike'), ('strike', 8.1, 'ended'), ('regain', 0.9, 'regain'),
    ('regain', 1.1, 'line_up')])
def test_the_last_steps_take_8_s_at_most_and_the_look_back_1(state, seconds, after):
    made, skill = lining_up(state, seconds=seconds, unseen=0.41)
    getattr(skill, state)(made)
    assert skill.state.__name__ == after


@pytest.mark.parametrize('unseen, after', [(0.39, 'line_up'), (0.41, 'regain')])
def test_a_ball_that_is_seen_again_within_0_4_s_ends_the_look_back(unseen, after):
    made, skill = lining_up('regain', unseen=unseen)
    skill.regain(made)
    assert skill.state.__name__ == after


@pytest.mark.parametrize('seconds, seen_ago, after', [
    (2.5, 9.0, 'look_for_goal'), (2.7, 9.0, 'regain'), (1.0, 1.5, 'look_for_goal'),
    (1.0, 0.5, 'regain')])
def test_the_goal_is_looked_for_2_6_s_or_until_it_is_seen(seconds, seen_ago, after):
    made, skill = lining_up('look_for_goal', seconds=seconds, seen_ago=seen_ago)
    skill.skill = SimpleNamespace(step=lambda *asked: kelpie.HeadRequest())
    skill.look_for_goal(made)
    assert skill.state.__name__ == after
    assert (skill.goal.looked_s == 50.0) is (after == 'regain')


@pytest.mark.parametrize('state, down', [('kick', 20.0), ('ended', 12.0)])
def test_it_looks_20_deg_down_as_it_kicks_and_12_after(state, down):
    made, skill = lining_up('ended')
    skill.skill = SimpleNamespace(step=lambda one: kelpie.KICK_FORWARD, done=False)
    head = getattr(skill, state)(made).head
    assert head.head_pan_deg == 0.0
    assert 14.25 - head.neck_tilt_deg - head.head_nod_deg == pytest.approx(down)


@pytest.mark.parametrize('state, committed', [
    ('approach', False), ('line_up', False), ('strike', True), ('kick', True),
    ('look_for_goal', True), ('regain', True), ('ended', False)])
def test_who_stands_for_a_kick_or_looks_for_the_goal_is_not_interrupted(state, committed):
    _, skill = lining_up(state)
    assert skill.committed is committed and skill.done is (state == 'ended')


# The map's choice

def dribble(gap=None, standing=False, carries=False):
    return SimpleNamespace(aim=SimpleNamespace(gap=gap), standing=standing,
                           should_carry=lambda one: carries)


@pytest.mark.parametrize('share, standing, kicks', [
    (0.94, False, True), (0.92, False, False), (0.81, True, True), (0.79, True, False)])
def test_a_kick_is_made_from_0_93_of_the_aimed_one_on_and_from_0_8_by_who_has_stopped(
        monkeypatch, share, standing, kicks):
    made = world(180.0, 400.0)
    monkeypatch.setattr(kick_map_choice, 'best', lambda *asked: (0.5 * share, kelpie.WEDGE))
    monkeypatch.setattr(kick_map_choice, 'utility_of', lambda *asked: 0.5)
    found = kick_map_choice.choose(made, dribble((10.0, -10.0), standing), False)
    assert (found is not None) is kicks
    assert not kicks or found[0] == kelpie.WEDGE
    assert kick_map_choice.choose(made, dribble((10.0, -10.0), standing, True), False) is None


@pytest.mark.parametrize('gap, middle', [((30.0, 10.0), 20.0), ((-10.0, -30.0), -20.0),
                                         ((10.0, -10.0), 0.0)])
def test_the_aimed_kick_is_one_at_the_middle_of_the_gap(monkeypatch, gap, middle):
    turns = []
    monkeypatch.setattr(kick_map_choice, 'best', lambda one, two, three: (0.1, turns.append(three)))
    monkeypatch.setattr(kick_map_choice, 'utility_of',
                        lambda one, kick, free, turn: turns.append(turn) or 0.5)
    kick_map_choice.choose(world(180.0, 400.0), dribble(gap), False)
    assert set(turns) == {middle}


@pytest.mark.parametrize('utility, kicks', [(0.0, False), (0.01, True)])
def test_without_any_utility_nothing_is_kicked(monkeypatch, utility, kicks):
    monkeypatch.setattr(kick_map_choice, 'best', lambda *asked: (utility, kelpie.WEDGE))
    monkeypatch.setattr(kick_map_choice, 'utility_of', lambda *asked: -1.0)
    found = kick_map_choice.choose(world(180.0, 400.0), dribble((10.0, -10.0)), False)
    assert (found is not None) is kicks


@pytest.mark.parametrize('beyond, weighed', [(29.0, True), (31.0, False)])
def test_only_kicks_within_30_deg_of_the_gap_are_weighed(beyond, weighed):
    """The gap's middle is so far beyond the kick that goes farthest to a side."""
    made = world(180.0, 300.0)
    ways = [kick_table.held_outcome(kick)[1] for kick in kick_table.kicks(True)]
    for middle in (max(ways) + beyond, min(ways) - beyond):
        utility, kick = kick_map_choice.best(made, (middle + 5.0, middle - 5.0), middle)
        assert (utility > 0.0) is weighed and (weighed or kick == kelpie.HARD_FORWARD)


def test_a_kicks_direction_is_unsure_by_7_deg_and_the_pose(monkeypatch):
    asked = []
    monkeypatch.setattr(kick_table, 'chance_of_goal',
                        lambda *one, **two: asked.append(two['heading_sd']) or 0.0)
    made = world(180.0, 450.0)
    made.heading_sd_deg = 24.0
    kick_map_choice.utility_of(made, kelpie.HARD_FORWARD, (10.0, -10.0), 0.0)
    assert asked == [25.0]


def test_a_goal_is_worth_1_and_a_miss_where_it_lies(monkeypatch):
    monkeypatch.setattr(kick_table, 'chance_of_goal', lambda *one, **two: 0.25)
    made, outcome = world(180.0, 300.0), (0.8, 0.0, 5.0, 100.0, 10.0)
    there = kick_map_choice.nearness(made.field, 180.0, 408.0)
    found = kick_map_choice.utility_of_way(made, (180.0, 308.0), 90.0, outcome)
    assert found == pytest.approx(0.25 + 0.75 * 0.8 * there)
