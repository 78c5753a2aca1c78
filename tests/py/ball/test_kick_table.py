# SPDX-License-Identifier: Apache-2.0
"""The kick table: what it reads from the map between the map's places, mirrored, and the chance of
a goal that follows."""
import math
import random
from types import SimpleNamespace

import kelpie
import pytest
from data import kick_map
from lib import kick_table
from lib.geom import heading, moved

FIELD = kelpie.FIELDS['2006']
MIDDLE = 0.5 * FIELD.width
LEFT_KICKS = [kelpie.HEAD_SWIPE_LEFT, kelpie.UPENN_LEFT]
MIRRORED = {kelpie.HEAD_SWIPE_LEFT: kelpie.HEAD_SWIPE_RIGHT,
            kelpie.UPENN_LEFT: kelpie.UPENN_RIGHT, kelpie.KICK_FORWARD: kelpie.KICK_FORWARD}
STRAIGHT = (1.0, 0.0, 5.0, 200.0, 30.0)


def pose(x, y, heading=90.0):
    return kelpie.Pose2(position=kelpie.Point2(x=x, y=y), heading_deg=heading)


def goal_chance(ball, outcome=STRAIGHT, heading=90.0, **options):
    robot = pose(ball[0], ball[1] - 14.0, heading)
    return kick_table.chance_of_goal(robot, ball, outcome, FIELD, **options)


@pytest.fixture
def small_map(monkeypatch):
    """Two by two places; from the right near one no ball goes, the left far one is the robot's."""
    cells = ((100, 40, 4, 200, 20, 0), (0, 0, 0, 0, 0, 0)), (None, (50, 10, 8, 100, 10, 0))
    monkeypatch.setattr(kick_map, 'STANDING', {kelpie.UPENN_LEFT: {
        'frames': 6, 'way': (-4.0, 5.0, 36), 'whole': (90, 30, 6, 150, 20, 0),
        'ahead': (10, 12), 'aside': (2, 4), 'best': (2, 10), 'window': ((2, 10), (4, 10)),
        'places': cells}})


def test_at_a_place_of_the_map_the_outcome_is_the_one_measured_there(small_map):
    assert kick_table.outcome(kelpie.UPENN_LEFT, 2, 10) == (1.0, 40.0, 4.0, 200.0, 20.0)


def test_between_two_places_chances_are_shared(small_map):
    chance, direction, sd, distance, distance_sd = kick_table.outcome(kelpie.UPENN_LEFT, 3, 10)
    assert chance == pytest.approx(0.5)
    # Of the place from where no ball goes nothing is known but that.
    assert (direction, sd, distance, distance_sd) == (40.0, 4.0, 200.0, 20.0)


def test_directions_are_weighted_by_the_balls_that_went(monkeypatch, small_map):
    monkeypatch.setitem(kick_map.STANDING[kelpie.UPENN_LEFT], 'places', (
        ((100, 40, 4, 200, 20, 0), (100, 20, 8, 100, 40, 0)),
        ((50, 10, 4, 50, 20, 0), (50, 10, 8, 50, 40, 0))))
    assert kick_table.outcome(kelpie.UPENN_LEFT, 3, 10) == (1.0, 30.0, 6.0, 150.0, 30.0)
    assert kick_table.outcome(kelpie.UPENN_LEFT, 2, 11)[1] == pytest.approx(30.0)


@pytest.mark.parametrize('x, y', [(1.9, 10), (4.1, 10), (2, 9.9), (2, 12.1)])
def test_outside_the_map_nothing_is_known(small_map, x, y):
    assert kick_table.outcome(kelpie.UPENN_LEFT, x, y) is None


def test_where_no_ball_can_lie_nothing_is_known_and_next_to_it_neither(small_map):
    assert kick_table.outcome(kelpie.UPENN_LEFT, 2, 12) is None
    assert kick_table.outcome(kelpie.UPENN_LEFT, 3, 11) is None
    assert kick_table.outcome(kelpie.UPENN_LEFT, 4, 12) is not None


def test_a_kick_that_needs_the_hold_has_no_outcome_of_a_free_ball():
    assert kick_table.outcome(kelpie.HARD_FORWARD, 0, 8) is None
    assert kick_table.held_outcome(kelpie.KICK_FORWARD) is None


@pytest.mark.parametrize('kick', MIRRORED)
def test_the_other_sides_outcomes_are_mirrored(kick):
    rng = random.Random(3)
    for _ in range(200):
        x, y = rng.uniform(-11, 11), rng.uniform(9, 19)
        here = kick_table.outcome(kick, x, y)
        there = kick_table.outcome(MIRRORED[kick], -x, y)
        assert (here is None) == (there is None)
        if here:
            assert here == (there[0], -there[1]) + there[2:]


@pytest.mark.parametrize('kick', LEFT_KICKS)
def test_a_kick_to_the_left_goes_left_and_its_mirror_image_right(kick):
    assert kick_table.outcome(kick, *kick_table.best_place(kick))[1] > 15.0
    right = MIRRORED[kick]
    assert kick_table.outcome(right, *kick_table.best_place(right))[1] < -15.0
    assert kick_table.held_outcome(kick)[1] > 15.0 > -15.0 > kick_table.held_outcome(right)[1]
    assert kick_table.turn_way(kick)[2] == -kick_table.turn_way(right)[2] > 0.0


def test_every_kick_of_the_map_is_known_by_both_its_sides():
    assert set(kick_table.kicks(False)) == set(MIRRORED) | set(MIRRORED.values())
    assert {kelpie.HARD_FORWARD, kelpie.WEDGE} < set(kick_table.kicks(True))
    for kick in kick_table.kicks(True):
        assert kick_table.held_outcome(kick)[0] >= 0.8
        assert 0 < kick_table.frames(kick, held=True) <= 20


@pytest.mark.parametrize('walking', [False, True])
@pytest.mark.parametrize('kick', kick_table.kicks(False))
def test_from_the_best_place_and_all_its_window_the_ball_goes(kick, walking):
    min_x, min_y, max_x, max_y = kick_table.window(kick, walking)
    x, y = kick_table.best_place(kick, walking)
    assert min_x <= x <= max_x and min_y <= y <= max_y
    rng = random.Random(5)
    for _ in range(50):
        place = rng.uniform(min_x, max_x), rng.uniform(min_y, max_y)
        assert kick_table.outcome(kick, *place, walking)[0] >= 0.8
    assert kick_table.window_outcome(kick, walking)[0] >= 0.8


@pytest.mark.parametrize('walking', [False, True])
@pytest.mark.parametrize('kick', kick_table.kicks(False))
def test_every_outcome_is_a_possible_one(kick, walking):
    rng = random.Random(7)
    for _ in range(500):
        found = kick_table.outcome(kick, rng.uniform(-12, 12), rng.uniform(8, 20), walking)
        if found is None:
            continue
        chance, direction, sd, distance, distance_sd = found
        assert 0.0 <= chance <= 1.0 and abs(direction) <= 180.0 and 0.0 <= sd <= 90.0
        assert 0.0 <= distance <= 400.0 and distance_sd >= 0.0
        assert chance == 0.0 or distance > 30.0


def test_a_walking_robot_comes_nearer_until_its_kick_begins():
    x, y, turned = kick_table.at_kick(2.0, 16.0, 20.0, 0.0, 0.0)
    assert (x, turned) == (2.0, 0.0) and 16.0 - y == pytest.approx(20.0 * kick_map.UNTIL_KICK)
    x, y, _ = kick_table.at_kick(2.0, 16.0, 0.0, 10.0, 0.0)
    assert x - 2.0 == pytest.approx(10.0 * kick_map.UNTIL_KICK) and y == 16.0


def test_a_turning_robot_sees_the_ball_go_round_the_other_way():
    x, y, turned = kick_table.at_kick(0.0, 14.0, 0.0, 0.0, 50.0)
    assert turned == pytest.approx(50.0 * kick_map.UNTIL_KICK)
    assert heading(x, y) == pytest.approx(-turned) and math.hypot(x, y) == pytest.approx(14.0)


def test_walking_until_the_kick_is_as_odometry_moves_a_resting_ball():
    step = SimpleNamespace(forward=15.0 * kick_map.UNTIL_KICK, left=-4.0 * kick_map.UNTIL_KICK,
                           turn_deg=17.0 * kick_map.UNTIL_KICK)
    assert kick_table.at_kick(3.0, 15.0, 15.0, -4.0, 17.0)[:2] == pytest.approx(
        moved(3.0, 15.0, step))


def test_a_chance_of_a_goal_is_the_share_of_random_balls_that_roll_in():
    rng = random.Random(11)
    for ball, heading, outcome in [((MIDDLE, 400.0), 90.0, STRAIGHT),
                                   ((100.0, 420.0), 60.0, (0.9, 0.0, 12.0, 180.0, 40.0)),
                                   ((300.0, 500.0), 120.0, (1.0, 40.0, 10.0, 150.0, 50.0)),
                                   ((200.0, 350.0), 140.0, (0.8, -45.0, 9.0, 220.0, 30.0))]:
        hits = 0
        for _ in range(20000):
            if rng.random() > outcome[0]:
                continue
            angle = math.radians(heading + rng.gauss(outcome[1], outcome[2]))
            rolls = rng.gauss(outcome[3], outcome[4])
            to_line = FIELD.length + 4.2 - ball[1]
            if rolls * math.sin(angle) < to_line:
                continue
            x = ball[0] + (FIELD.length - ball[1]) / math.tan(angle)
            hits += abs(x - MIDDLE) < 0.5 * FIELD.goal_width - 4.2
        assert goal_chance(ball, outcome, heading) == pytest.approx(hits / 20000, abs=0.015)


def test_a_goal_is_less_likely_from_farther_away_from_a_side_and_with_an_unsure_heading():
    near, far = goal_chance((MIDDLE, 440.0)), goal_chance((MIDDLE, 340.0))
    assert near > 0.9 > far
    assert goal_chance((MIDDLE, 440.0), heading=60.0) < 0.2
    assert goal_chance((MIDDLE, 440.0), heading_sd=20.0) < near - 0.2
    assert goal_chance((MIDDLE, 200.0)) < 1e-6


def test_only_the_free_gap_counts():
    ball = (MIDDLE, 440.0)
    whole = goal_chance(ball)
    assert goal_chance(ball, gap=(-90.0, 90.0)) == pytest.approx(whole)
    left, right = (goal_chance(ball, gap=gap) for gap in [(0.0, 60.0), (-60.0, 0.0)])
    assert left == pytest.approx(0.5 * whole, abs=0.01) and left + right == pytest.approx(whole)
    assert goal_chance(ball, gap=(40.0, 90.0)) == 0.0


def test_what_is_blocked_and_what_is_free_add_up_to_the_whole():
    ball = (MIDDLE + 20.0, 430.0)
    whole = goal_chance(ball, heading=95.0)
    gap = goal_chance(ball, heading=95.0, gap=(-4.0, 7.0))
    blocked = goal_chance(ball, heading=95.0, blocked=[(-4.0, 7.0)])
    assert gap > 0.05 and gap + blocked == pytest.approx(whole, abs=0.01)
    assert goal_chance(ball, heading=95.0, blocked=[(-90.0, 0.0), (-5.0, 90.0)]) == 0.0


def test_directions_that_are_given_around_the_back_are_the_same_ones():
    ball = (MIDDLE, 460.0)
    robot = pose(MIDDLE, 474.0, -90.0)
    behind = (1.0, 180.0, 5.0, 200.0, 30.0)
    whole = kick_table.chance_of_goal(robot, ball, behind, FIELD)
    assert whole > 0.9
    assert kick_table.chance_of_goal(robot, ball, behind, FIELD,
                                     gap=(120.0, -120.0)) == pytest.approx(whole)
    assert kick_table.chance_of_goal(robot, ball, behind, FIELD,
                                     blocked=[(120.0, -120.0)]) == 0.0


def test_no_random_place_on_the_field_has_an_impossible_chance():
    rng = random.Random(13)
    for _ in range(2000):
        ball = rng.uniform(-20, FIELD.width + 20), rng.uniform(-20, FIELD.length + 20)
        outcome = (rng.random(), rng.uniform(-180, 180), rng.uniform(0, 40), rng.uniform(0, 300),
                   rng.uniform(0, 60))
        chance = goal_chance(ball, outcome, rng.uniform(-180, 180),
                             gap=(rng.uniform(-180, 180), rng.uniform(-180, 180)),
                             heading_sd=rng.uniform(0, 30))
        assert 0.0 <= chance <= outcome[0] + 1e-9
