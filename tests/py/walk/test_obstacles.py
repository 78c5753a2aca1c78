# SPDX-License-Identifier: Apache-2.0
"""What behaviours ask of the obstacle map."""
import math
import random

import kelpie
import pytest
from situation import obstacles

HERE = kelpie.Pose2(position=kelpie.Point2(x=180.0, y=270.0), heading_deg=90.0)


def world_of(*cells):
    """A world with cells of (x, y, own, heard)."""
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'], pose=HERE)
    world.obstacles = [kelpie.ObstacleCell(position=kelpie.Point2(x=x, y=y), own=own, heard=heard)
                       for x, y, own, heard in cells]
    return world


def points(*cells):
    return obstacles.points_of(world_of(*cells), landmarks=False)


def test_a_corridor_counts_what_stands_in_its_width_and_length_only():
    seen = points((180, 330, 12, 0))
    assert obstacles.between(seen, (180, 270), (180, 400)) == 12
    assert obstacles.between(seen, (180, 270), (180, 300)) == 0
    assert obstacles.between(seen, (180, 270), (280, 400)) == 0
    assert obstacles.between(seen, (180, 270), (280, 400), width=100) == 12


def test_a_corridor_may_lead_between_any_two_places():
    seen = points((60, 100, 7, 0))
    assert obstacles.between(seen, (20, 60), (300, 340)) == 7
    assert obstacles.between(seen, (300, 340), (20, 60)) == 7
    assert obstacles.between(seen, (60, 95), (60, 95)) == 7


def test_a_wider_corridor_and_one_more_obstacle_never_make_a_way_freer():
    draw = random.Random(41)
    seen = []
    for _ in range(200):
        start, end = [(draw.uniform(0, 360), draw.uniform(0, 540)) for _ in range(2)]
        before = obstacles.between(seen, start, end)
        seen.append((draw.uniform(0, 360), draw.uniform(0, 540), draw.uniform(1, 50)))
        assert obstacles.between(seen, start, end) >= before
        assert obstacles.between(seen, start, end, width=90) >= obstacles.between(seen, start, end)


def test_own_heard_and_landmarks_can_be_asked_for_alone():
    world = world_of((100, 300, 5, 0), (200, 300, 0, 9), (250, 300, 2, 3))
    ask = obstacles.points_of
    assert sum(count for *_, count in ask(world, heard=False, landmarks=False)) == 7
    assert sum(count for *_, count in ask(world, own=False, landmarks=False)) == 12
    assert len(ask(world, own=False, landmarks=False)) == 2
    assert ask(world, own=False, heard=False) == obstacles.standing(world.field)


def test_near_a_place_stands_what_of_the_map_lies_there():
    random_cells = random.Random(5)
    world = world_of(*((random_cells.uniform(0, 360), random_cells.uniform(0, 540),
                        random_cells.uniform(0, 9), random_cells.uniform(0, 9)) for _ in range(90)))
    near = [(x, y, count) for x, y, count in obstacles.points_of(world, landmarks=False)
            if abs(x - 200) < 70 and abs(y - 300) < 70]
    assert len(near) > 3
    assert obstacles.points_near(world, kelpie.Point2(x=200.0, y=300.0), 70.0) == near


def test_beacons_and_the_walls_of_goals_stand_and_a_goal_mouth_is_free():
    seen = obstacles.points_of(world_of())
    assert obstacles.between(seen, (150, 570), (210, 570)) >= 40      # the far goal's back wall
    assert obstacles.between(seen, (180, 500), (180, 550)) == 0       # through its mouth
    assert obstacles.between(seen, (-15, 120), (-15, 150)) == 40      # a beacon


def test_a_sector_is_counted_from_the_heading_and_an_arc_from_near_to_far():
    x, y = 180 - 60 * math.sin(math.radians(60)), 270 + 60 * math.cos(math.radians(60))
    seen = points((x, y, 15, 0))
    assert obstacles.in_sector(seen, HERE, 60, 30, far=100) == 15
    assert obstacles.in_sector(seen, HERE, 70, 10, far=100) == 0
    assert obstacles.in_sector(seen, HERE, -60, 30, far=100) == 0
    assert obstacles.in_sector(seen, HERE, 60, 30, far=50) == 0
    assert obstacles.in_sector(seen, HERE, 60, 30, near=70, far=100) == 0
    assert obstacles.in_sector(seen, HERE, 60, 30, near=50, far=100) == 15


def test_a_sector_behind_counts_on_both_sides_of_straight_back():
    seen = points((170, 200, 4, 0), (190, 200, 4, 0))
    assert obstacles.in_sector(seen, HERE, 180, 40, far=100) == 8


def test_a_box_is_of_the_robot_frame():
    seen = points((160, 320, 3, 0), (180, 400, 5, 0))
    assert obstacles.in_box(seen, HERE, -25, 25, 20, 100) == 3
    turned = kelpie.Pose2(position=HERE.position, heading_deg=0.0)
    assert obstacles.in_box(seen, turned, -60, -40, -30, -10) == 3


def test_the_nearest_is_the_nearest_full_cell_of_a_sector():
    seen = points((180, 310, 4, 0), (180, 330, 20, 0), (180, 390, 90, 0))
    assert obstacles.nearest(seen, HERE, 0, 30) == pytest.approx(60)
    assert obstacles.nearest(seen, HERE, 0, 30, count=3) == pytest.approx(40)
    assert obstacles.nearest(seen, HERE, 90, 30) == math.inf


def test_the_gap_is_the_desired_way_when_that_is_free():
    assert obstacles.gap([], HERE, 25)[0] == 25


def at(degrees, away, count=20):
    angle = math.radians(degrees)
    return (180 - away * math.sin(angle), 270 + away * math.cos(angle), count, 0)


def test_the_gap_passes_an_obstacle_on_the_nearer_side():
    seen = points(*[at(degrees, 40) for degrees in (-30, -20, -10, 0, 10)])
    degrees, width = obstacles.gap(seen, HERE, 0)
    half_a_cell = math.degrees(math.asin(7.071 / 40))     # of its diagonal
    assert degrees == pytest.approx(10 + half_a_cell + 10, abs=0.01)
    assert width == pytest.approx(110 - 10 - half_a_cell, abs=0.01)
    assert obstacles.gap(seen, HERE, 0, reach=30)[0] == 0


@pytest.mark.parametrize('away', range(13, 51, 3))
@pytest.mark.parametrize('offset', (0.0, 2.5, 5.0))
def test_no_gap_leads_through_a_closed_row_of_cells(away, offset):
    row = points(*[(180 + offset + 10 * i, 270 + away, 30, 0) for i in range(-30, 31)])
    for wanted in range(-180, 181, 15):
        way = obstacles.gap(row, HERE, wanted)
        # Past 90 deg the way leads away from the row, farther ahead it meets it beyond the reach.
        if way is not None:
            assert away / max(math.cos(math.radians(way[0])), 1e-9) > obstacles.GAP_REACH


def test_the_back_wall_of_a_goal_is_no_way():
    seen = obstacles.points_of(world_of())
    for x in range(150, 211, 5):
        pose = kelpie.Pose2(position=kelpie.Point2(x=float(x), y=552.0), heading_deg=90.0)
        way = obstacles.gap(seen, pose, 0)
        assert way is None or abs(way[0]) > 80


def test_what_the_robot_stands_on_blocks_no_way():
    seen = points((180, 275, 80, 0))
    assert obstacles.gap(seen, HERE, 0) == (0, 220)
    assert obstacles.nearest(seen, HERE, 0, 180) == math.inf


def test_a_direction_may_be_turned_round_as_often_as_one_likes():
    assert obstacles.gap([], HERE, 350) == obstacles.gap([], HERE, -10)
    assert obstacles.gap([], HERE, 200) == obstacles.gap([], HERE, -160)
    assert obstacles.gap([], HERE, -160)[0] == -100


@pytest.mark.parametrize('ask', [
    lambda nan: obstacles.between([], (0, nan), (1, 1)),
    lambda nan: obstacles.in_box([], HERE, -1, 1, nan, 1),
    lambda nan: obstacles.in_sector([], HERE, nan, 10, far=10),
    lambda nan: obstacles.nearest([], HERE, nan, 10),
    lambda nan: obstacles.gap([], HERE, 0, reach=nan)])
def test_what_is_not_a_number_is_refused_rather_than_free(ask):
    with pytest.raises(ValueError):
        ask(math.nan)


def test_there_is_no_gap_where_all_ways_ahead_are_blocked_or_too_narrow():
    seen = points(*[at(degrees, 40) for degrees in range(-120, 121, 20)])
    assert obstacles.gap(seen, HERE, 0) is None


def test_a_cell_with_few_points_blocks_no_way():
    assert obstacles.gap(points(at(0, 40, count=5)), HERE, 0)[0] == 0
