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


def test_near_a_place_stands_what_the_robot_saw_there_or_heard_of():
    draw = random.Random(5)
    cells = [(draw.uniform(0, 360), draw.uniform(0, 540), draw.uniform(0, 9), draw.uniform(0, 9))
             for _ in range(90)]
    near = [(x, y, own + heard) for x, y, own, heard in cells
            if abs(x - 200) < 70 and abs(y - 300) < 70]
    assert len(near) > 3
    place = kelpie.Point2(x=200.0, y=300.0)
    assert obstacles.points_near(world_of(*cells), place, 70.0) == near


def test_a_box_is_of_the_robot_frame():
    seen = [(160.0, 320.0, 3.0), (180.0, 400.0, 5.0)]
    assert obstacles.in_box(seen, HERE, -25, 25, 20, 100) == 3
    turned = kelpie.Pose2(position=HERE.position, heading_deg=0.0)
    assert obstacles.in_box(seen, turned, -60, -40, -30, -10) == 3


@pytest.mark.parametrize('which', range(4))
def test_a_box_whose_side_is_not_a_number_is_refused_rather_than_free(which):
    sides = [-1.0, 1.0, 0.0, 1.0]
    sides[which] = math.nan
    with pytest.raises(ValueError):
        obstacles.in_box([], HERE, *sides)
