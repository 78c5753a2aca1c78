# SPDX-License-Identifier: Apache-2.0
"""What a robot that stands or turns on the spot looks at and how fast it turns: the rows of a look
round, the turn of a goalie that faces the wrong way, and its look about for a near ball."""
from types import SimpleNamespace

import kelpie
import pytest
from situations import put_ball, world
from skills.walk.face_up_field import FaceUpField
from skills.walk.look_about import LookAbout
from skills.walk.look_round import LookRound

FRAME_S = 1.0 / 30.0


def down(request, made):
    """deg of the view below the horizon."""
    return made.stance.body_tilt_deg - request.neck_tilt_deg - request.head_nod_deg


def at(skill, made, seconds):
    made.time_s = seconds
    return skill.step(made).head


# Looking round: 172 deg at 75 deg/s take 2.293 s, after 0.35 s in which the head comes to the end.

def test_the_first_row_goes_from_86_deg_left_to_right_at_75_deg_a_second_4_deg_down():
    made, skill = world(), LookRound()
    for seconds, pan in ((0.0, 86.0), (0.34, 86.0), (1.35, 11.0), (2.35, -64.0)):
        head = at(skill, made, seconds)
        assert (head.head_pan_deg, down(head, made)) == pytest.approx((pan, 4.0))


def after_one_row():
    made, skill = world(), LookRound()
    at(skill, made, 0.0)
    at(skill, made, 2.65)
    return made, skill


def test_the_second_row_comes_back_18_deg_down():
    made, skill = after_one_row()
    assert (skill.rows, skill.rounds, skill.turning) == (1, 0, False)
    for seconds, pan in ((2.7, -86.0), (4.0, -11.0), (5.0, 64.0)):
        head = at(skill, made, seconds)
        assert (head.head_pan_deg, down(head, made)) == pytest.approx((pan, 18.0))


def test_after_two_rows_the_body_turns_115_deg_to_the_left_and_all_begins_anew():
    made, skill = after_one_row()
    at(skill, made, 5.3)
    assert skill.turning and skill.rows == 2
    made.odometry.turn_deg = 23.0
    for turn in range(1, 6):
        command = skill.step(made)
        assert command.walk.turn_deg == 60.0
        assert command.head.head_pan_deg == 86.0 and down(command.head, made) == pytest.approx(4.0)
        assert skill.turning is (turn < 5) and skill.rounds == (turn == 5)
    assert at(skill, made, 5.65 + 1.0).head_pan_deg == pytest.approx(86.0 - 75.0)


def test_the_next_turn_is_counted_from_its_own_beginning():
    made, skill = after_one_row()
    made.odometry.turn_deg = 115.0
    for seconds in (5.3, 5.4, 8.1, 10.8):
        at(skill, made, seconds)
    made.odometry.turn_deg = 60.0
    at(skill, made, 10.9)
    assert skill.turning and skill.rounds == 1
    at(skill, made, 11.0)
    assert not skill.turning and skill.rounds == 2


# Facing up-field

@pytest.mark.parametrize('side, branch', [(1.0, 'left'), (-1.0, 'right')])
def test_who_faces_the_wrong_way_turns_at_120_deg_a_second_and_looks_20_deg_ahead_of_it(side,
                                                                                       branch):
    begun, trace, made = [], [], world()
    facing = SimpleNamespace(begin_turn=begun.append, turn_on=lambda: side, side=side, own_goal=3,
                             end_turn=lambda: begun.append('end'))
    skill = FaceUpField(made, facing)
    command = skill.step(made)
    assert command.walk.turn_deg == side * 120.0 and command.walk.forward == 0.0
    assert command.head.head_pan_deg == side * 20.0
    assert down(command.head, made) == pytest.approx(6.0)
    skill.explain(trace)
    skill.end()
    assert trace[0][2] == branch and trace[0][-1] == 3 and begun == [made, 'end']


# Looking about

def about(side=0.0, up_deg=0.0, seen_since=True, kicked=False, ball=None, opponents=()):
    """The walk; `up_deg`: how far up-field is to the left."""
    made = world(180.0, 40.0)
    put_ball(made, *(ball or (180.0, 140.0)))
    made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y))
                      for x, y in opponents]
    now = SimpleNamespace(world=made, seen_since_motion=seen_since, kicked=kicked,
                          facing=SimpleNamespace(up_deg=up_deg))
    walk = LookAbout(now).step(made, side)
    return walk.forward, walk.left, walk.turn_deg


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('situation, turn', [
    ({}, 110.0), ({'kicked': True}, 110.0), ({'seen_since': False}, 110.0),
    ({'seen_since': False, 'kicked': True}, 70.0)])
def test_it_turns_to_where_the_ball_was_lost_and_slower_after_a_kick(side, situation, turn):
    assert about(side, **situation) == (0.0, 0.0, side * turn)


@pytest.mark.parametrize('side, up_deg, turns', [
    (1.0, -104.0, True), (1.0, -106.0, False), (-1.0, 104.0, True), (-1.0, 106.0, False),
    (1.0, 106.0, True)])
def test_it_turns_no_farther_than_105_deg_from_up_field(side, up_deg, turns):
    assert (about(side, up_deg)[2] != 0.0) is turns


@pytest.mark.parametrize('side', [0.0, 1.0])
@pytest.mark.parametrize('away, stands', [(49.0, True), (51.0, False)])
def test_with_an_opponent_within_50_cm_it_stands(side, away, stands):
    walk = about(side, ball=(180.0, 50.0), opponents=[(180.0, 40.0 + away)])
    assert (walk == (0.0, 0.0, 0.0)) is stands


@pytest.mark.parametrize('ahead, seen_since, forward', [
    (10.0, True, -15.0), (10.0, False, 0.0), (20.0, True, 0.0)])
def test_a_ball_under_the_chin_is_backed_off_from_unless_a_motion_moved_it(ahead, seen_since,
                                                                         forward):
    walk = about(0.0, seen_since=seen_since, ball=(180.0, 40.0 + ahead))
    assert walk == pytest.approx((forward, 0.0, 0.0))
