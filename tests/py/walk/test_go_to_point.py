# SPDX-License-Identifier: Apache-2.0
"""The walk to a point of the field: turns, goes ahead, stands, and says that it is there."""
import pytest
from situations import world
from skills.walk.go_to_point import GoToPoint

POINT = (180.0, 300.0)


def walking(below, heading=90.0, turning=False, near=3.0):
    """The walk of a robot that many cm below the point."""
    made, skill = world(180.0, 300.0 - below, heading), GoToPoint(POINT, near)
    skill.turning = turning
    return skill.walk_there(made), skill


@pytest.mark.parametrize('off, before, turns', [
    (5.0, True, False), (7.0, True, True), (-7.0, True, True), (21.0, False, False),
    (23.0, False, True), (-23.0, False, True)])
def test_it_turns_on_the_spot_from_22_degrees_on_until_it_faces_the_point_to_6(off, before, turns):
    walk, skill = walking(100.0, 90.0 + off, before)
    assert skill.turning is turns and (walk.forward == 0.0) is turns
    assert walk.turn_deg * off < 0.0


@pytest.mark.parametrize('off, turn', [(30.0, -60.0), (39.0, -78.0), (90.0, -80.0), (-90.0, 80.0)])
def test_on_the_spot_it_turns_by_twice_the_angle_and_at_80_degrees_a_second_at_most(off, turn):
    assert walking(100.0, 90.0 + off)[0].turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('away, forward', [(100.0, 32.0), (20.0, 26.0), (10.0, 13.0), (4.0, 7.0)])
def test_the_way_ahead_is_slower_near_the_point(away, forward):
    assert walking(away)[0].forward == pytest.approx(forward)


def test_ahead_it_turns_half_as_fast():
    assert walking(100.0, 80.0)[0].turn_deg == pytest.approx(10.0)


@pytest.mark.parametrize('away, heading, backs', [
    (14.0, -90.0, True), (16.0, -90.0, False), (14.0, 1.0, False), (14.0, -1.0, True)])
def test_a_point_within_15_cm_behind_is_backed_to(away, heading, backs):
    walk, _ = walking(away, heading)
    assert (walk.forward == -7.0) is backs and (walk.turn_deg == 0.0) is backs


@pytest.mark.parametrize('away, near, off, turns', [(10.0, 3.0, 16.0, False),
                                                    (10.0, 3.0, 18.0, True)])
def test_near_the_point_3_cm_to_the_side_do_not_turn_it(away, near, off, turns):
    assert walking(away, 90.0 + off, True, near)[1].turning is turns


def test_at_the_point_it_stands_until_it_is_twice_as_far_off_as_counts_as_there():
    made, skill = world(180.0, 297.5), GoToPoint(POINT, 3.0)
    for below, stands in ((2.5, True), (5.5, True), (6.5, False), (3.5, False), (2.5, True)):
        made.pose.position.y = 300.0 - below
        assert (skill.walk_there(made).forward == 0.0) is stands


@pytest.mark.parametrize('seconds, done', [(0.79, False), (0.81, True)])
def test_it_is_there_when_it_has_stood_for_0_8_s(seconds, done):
    made, skill = world(180.0, 298.0), GoToPoint(POINT, 3.0)
    skill.step(made)
    made.time_s += seconds
    skill.step(made)
    assert skill.done is done


@pytest.mark.parametrize('away, reached', [(5.9, True), (6.1, False)])
def test_a_place_before_the_point_is_reached_within_6_cm(away, reached):
    made, skill = world(180.0, 280.0 - away), GoToPoint(POINT, 3.0, (180.0, 280.0))
    skill.turning = False
    walk = skill.walk_there(made)
    assert (skill.first is None) is reached is skill.turning
    assert (walk.forward == 0.0) is reached


@pytest.mark.parametrize('below, heading, branch', [(2.0, 90.0, 'stand'), (100.0, 60.0, 'turn'),
                                                    (100.0, 90.0, 'walk')])
def test_it_tells_whether_it_stands_turns_or_walks(below, heading, branch):
    _, skill = walking(below, heading)
    trace = []
    skill.explain(trace)
    assert trace[0][2:] == (branch, 'the point is ({}, {})', 180.0, 300.0)
