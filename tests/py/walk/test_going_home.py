# SPDX-License-Identifier: Apache-2.0
"""How a robot without the ball walks: fast and round others from far, in any direction near its
place, off the attacker's ways, and back from a ball that counts as held."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from situation import keep_off
from situation.keep_off import Lane
from situation.memory import Memory
from situations import world
from skills.walk.avoid_attacker import AvoidAttacker
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.get_out_of_way import GetOutOfWay
from skills.walk.step_back import StepBack
from skills.walk.take_place import TakePlace

PLACE = (180.0, 400.0)


# Bird of Prey

def flying(away, off_deg=0.0, fast=False, bend=0.0):
    """The walk to a place so many cm off, that lies so many deg to the left; `fast`: it walks fast
    already."""
    made, bird = world(180.0, 400.0 - away, 90.0 - off_deg), BirdOfPrey()
    made.last_command.walk.kind = kelpie.WALK_FAST if fast else kelpie.WALK
    bird.bend, bird.frames = bend, 5
    return bird.step(made, PLACE)


@pytest.mark.parametrize('away, kind, forward', [
    (200.0, kelpie.WALK_FAST, 44.0), (61.0, kelpie.WALK_FAST, 44.0), (59.0, kelpie.WALK, 34.0),
    (20.0, kelpie.WALK, 24.0)])
def test_from_60_cm_on_it_takes_the_fast_walk_at_44_cm_a_second(away, kind, forward):
    walk = flying(away)
    assert walk.kind == kind and walk.forward == pytest.approx(forward)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('off_deg, before, fast', [
    (19.0, False, True), (21.0, False, False), (29.0, True, True), (31.0, True, False)])
def test_the_fast_walk_goes_ahead_to_within_20_deg_and_on_until_30(side, off_deg, before, fast):
    walk = flying(200.0, side * off_deg, before)
    assert (walk.kind == kelpie.WALK_FAST) is fast
    assert walk.turn_deg == pytest.approx(side * 1.8 * off_deg)


@pytest.mark.parametrize('away, turn', [(240.0, 54.0), (60.0, 54.0), (30.0, 27.0), (15.0, 13.5)])
def test_the_bend_of_the_way_fades_in_its_last_60_cm(away, turn):
    assert flying(away, bend=30.0).turn_deg == pytest.approx(turn)
    assert flying(away, bend=-30.0).turn_deg == pytest.approx(-turn)


def bends(frames, on=True, appears=0):
    """The bend of each frame; an opponent stands in the way, a little to its right, from frame
    number `appears` on."""
    made, bird, found = world(180.0, 100.0), BirdOfPrey(), []
    made.ball.present = False
    made.task.bird_of_prey = on
    for frame in range(frames):
        made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=185.0, y=250.0))
                          ] if frame >= appears else []
        bird.step(made, PLACE)
        found.append(bird.bend)
    return found, bird


def test_the_way_round_somebody_is_chosen_five_times_a_second():
    found, bird = bends(14, appears=1)
    assert found[:6] == [0.0] * 6 and all(bend > 0.0 for bend in found[6:])
    trace = []
    bird.explain(trace)
    assert trace[0][2] == 'left' and trace[0][4:] == (300.0, found[-1])


def test_without_the_switch_it_goes_straight_whoever_stands_there():
    assert bends(8, on=False)[0] == [0.0] * 8
    assert bends(1)[0][0] > 0.0


@pytest.mark.parametrize('bend, branch', [(0.0, 'straight'), (15.0, 'left'), (-15.0, 'right')])
def test_it_says_to_which_side_its_way_is_bent(bend, branch):
    bird, trace = BirdOfPrey(), []
    bird.bend = bend
    bird.explain(trace)
    assert trace[0][2] == branch


# Off the attacker's ways

LANE = Lane(keep_off.ON_WAY, (180.0, 100.0), (180.0, 300.0), 44.0)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('gap, avoids, leaves', [
    (43.5, False, True), (44.5, False, False), (44.5, True, True), (49.5, True, True),
    (50.5, True, False)])
def test_a_lane_is_left_from_within_its_clearance_until_6_cm_beyond(side, gap, avoids, leaves):
    made = world(180.0 + side * gap, 200.0)
    found = AvoidAttacker.lane(made, [LANE], keep_off.ON_WAY, avoids)
    assert (found is LANE) is leaves
    assert AvoidAttacker.lane(made, [LANE], keep_off.HAS_BALL, True) is None


@pytest.mark.parametrize('x, left', [(170.0, 34.0), (190.0, -34.0)])
def test_a_lane_is_left_by_the_shorter_way_sideways_with_the_ball_in_view(x, left):
    made, skill, trace = world(x, 200.0), AvoidAttacker(), []
    walk = skill.step(made, (LANE, (x + 100.0, 200.0)))
    assert (walk.forward, walk.left) == pytest.approx((0.0, left), abs=1e-6)
    assert walk.turn_deg == -90.0
    skill.explain(trace)
    assert trace[0][2:] == ('plan_b', '{} cm off its way', pytest.approx(10.0))


@pytest.mark.parametrize('role, frames', [
    (kelpie.DEFENDER, 75), (kelpie.STRIKER, 45), (kelpie.SUPPORTER, 45)])
def test_the_way_of_who_held_the_ball_is_left_free_for_some_frames_more(role, frames):
    made, skill = world(180.0, 200.0), GetOutOfWay(role)
    holds = Lane(keep_off.HOLDS, (180.0, 100.0), (180.0, 300.0), 60.0)
    assert skill.lane_to_leave(made, False) is None
    skill.update([LANE, holds])
    for _ in range(frames - 1):
        skill.update([])
        assert skill.lane_to_leave(made, False) is holds
    skill.update([])
    assert skill.lane_to_leave(made, False) is None


# A step back

def test_a_step_back_takes_0_4_s_of_the_walk_that_goes_back():
    made = world()
    made.time_s = 3.0
    skill = StepBack(made)
    for seconds, done in ((3.0, False), (3.39, False), (3.41, True)):
        made.time_s = seconds
        walk = skill.step(made)
        assert (walk.forward, walk.kind, skill.done) == (-50.0, kelpie.WALK_BACK, done)


# Before the kick-off; the goalie's place is (180, 20)

def taking(off, heading=90.0, state=None):
    """TakePlace of a goalie that is so many cm to the right of its place, and its walk."""
    made, skill = world(180.0 + off, 20.0, heading, (180.0, 270.0)), TakePlace(Memory(), True)
    made.game.state = kelpie.READY
    if state is not None:
        skill.enter(made, getattr(skill, state))
    command = skill.step(made)
    return skill.state.__name__, command


@pytest.mark.parametrize('off, heading, state', [
    (6.5, 90.0, 'stand'), (-6.5, 90.0, 'stand'), (7.5, 90.0, 'walk_there'),
    (0.0, 99.0, 'stand'), (0.0, 81.0, 'stand'), (0.0, 101.0, 'walk_there'),
    (0.0, 79.0, 'walk_there')])
def test_its_place_is_taken_within_7_cm_and_10_deg_of_up_field(off, heading, state):
    assert taking(off, heading)[0] == state


@pytest.mark.parametrize('off, heading, state', [
    (11.5, 90.0, 'stand'), (12.5, 90.0, 'walk_there'), (0.0, 109.0, 'stand'),
    (0.0, 111.0, 'walk_there'), (0.0, 69.0, 'walk_there')])
def test_it_is_left_beyond_12_cm_and_20_deg(off, heading, state):
    assert taking(off, heading, 'stand')[0] == state


@pytest.mark.parametrize('off, forward, left, turn', [
    (49.0, 0.0, 20.0, 0.0), (-49.0, 0.0, -20.0, 0.0), (51.0, 0.0, 0.0, 90.0),
    (-51.0, 0.0, 0.0, -90.0)])
def test_the_last_50_cm_are_walked_at_20_cm_a_second_looking_up_field(off, forward, left, turn):
    walk = taking(off)[1].walk
    assert (walk.forward, walk.left) == pytest.approx((forward, left), abs=1e-6)
    assert walk.turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('heading, turn', [(120.0, -54.0), (60.0, 54.0)])
def test_near_its_place_it_turns_up_field_while_it_walks(heading, turn):
    assert taking(20.0, heading)[1].walk.turn_deg == pytest.approx(turn)


def test_it_tells_the_team_where_it_goes():
    note = taking(100.0)[1].team
    assert note.wants and (note.wanted.x, note.wanted.y) == pytest.approx((180.0, 20.0))


@pytest.mark.parametrize('lost, present, tracks', [(0, True, True), (15, True, True),
                                                   (16, True, False), (0, False, False)])
def test_in_the_set_state_it_looks_at_the_ball_that_it_sees_and_else_scans(lost, present, tracks):
    made, memory = world(180.0, 20.0, 90.0, (180.0, 270.0)), Memory(ball_lost=lost)
    made.game.state, made.ball.present = kelpie.SET, present
    skill = TakePlace(memory, True)
    command = skill.step(made)
    assert skill.state == skill.set
    assert (command.head.aim == kelpie.AIM_POINT) is tracks
    walk = command.walk
    assert (walk.forward, walk.left, walk.turn_deg) == (0.0, 0.0, 0.0)
