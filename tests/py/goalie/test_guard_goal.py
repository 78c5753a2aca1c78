# SPDX-License-Identifier: Apache-2.0
"""How a goalie keeps its place: how far off it may be, and how fast it goes there."""
import math

import pytest
from goalie_world import world_at
from skills.walk.guard_goal import NONE, OF_2004, OF_2006, GuardGoal, walk_towards

# cm from the place and deg from its heading: from where on it moves, and until where.
TABLE = [(OF_2006, 8.0, 3.0, 14.0, 5.0), (OF_2004, 15.0, 7.0, 20.0, 8.0),
         (NONE, 2.0, 1.0, 30.0, 20.0)]


@pytest.mark.parametrize('laziness, lazy, accurate, lazy_turn, accurate_turn', TABLE)
def test_each_goalie_moves_and_turns_from_its_own_distance_on(laziness, lazy, accurate, lazy_turn,
                                                              accurate_turn):
    guard = GuardGoal(laziness)
    for off, moves in [(lazy - 0.1, False), (lazy + 0.1, True), (accurate + 0.1, True),
                       (accurate - 0.1, False)]:
        walk = guard.step(world_at(180.0, 30.0), (180.0 - off, 30.0, 90.0))
        assert (walk.left > 0.0, walk.turn_deg) == (moves, 0.0)
    for off, turns in [(lazy_turn - 0.1, False), (lazy_turn + 0.1, True),
                       (accurate_turn + 0.1, True), (accurate_turn - 0.1, False)]:
        for side in (1.0, -1.0):
            walk = guard.step(world_at(180.0, 30.0), (180.0, 30.0, 90.0 + side * off))
            assert (walk.turn_deg * side > 0.0, walk.left) == (turns, 0.0)


@pytest.mark.parametrize('off, pace', [(2.0, 5.0), (10.0, 25.0), (13.6, 34.0), (60.0, 34.0)])
def test_a_place_is_walked_to_by_2_5_of_the_way_a_second_and_at_34_cm_at_most(off, pace):
    for dx, dy in ((off, 0.0), (-off, 0.0), (0.0, off), (0.6 * off, 0.8 * off)):
        walk = walk_towards(world_at(180.0, 30.0), (180.0 + dx, 30.0 + dy, 90.0))
        assert math.hypot(walk.forward, walk.left) == pytest.approx(pace)
        assert (walk.forward, walk.left) == pytest.approx((pace * dy / off, -pace * dx / off))


@pytest.mark.parametrize('off_deg, turn', [(10.0, 30.0), (59.0, 177.0), (70.0, 180.0),
                                           (-10.0, -30.0), (-170.0, -180.0)])
def test_it_turns_by_three_times_the_angle_and_at_180_deg_a_second_at_most(off_deg, turn):
    walk = walk_towards(world_at(180.0, 30.0), (180.0, 30.0, 90.0 + off_deg))
    assert walk.turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('place, branch', [
    ((200.0, 30.0, 120.0), 'move'), ((180.0, 30.0, 120.0), 'turn'), ((180.0, 30.0, 90.0), 'stand')])
def test_it_says_whether_it_moves_turns_or_stands_and_how_far_off_it_is(place, branch):
    guard, trace = GuardGoal(OF_2006), []
    guard.step(world_at(180.0, 30.0), place)
    guard.explain(trace)
    assert trace[0][2] == branch
    assert trace[0][4:] == pytest.approx((place[0] - 180.0, place[2] - 90.0))


def test_a_place_outside_the_box_is_guarded_from_inside():
    """The box is 130 wide and 65 deep; the neck base keeps 10 cm inside it."""
    guard = GuardGoal(OF_2006)
    walk = guard.step(world_at(235.0, 55.0), (300.0, 200.0, 90.0))
    assert (walk.forward, walk.left) == pytest.approx((0.0, 0.0), abs=1e-6)
    assert guard.off == pytest.approx(0.0, abs=1e-6)
