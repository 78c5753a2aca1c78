# SPDX-License-Identifier: Apache-2.0
# What stands near a place or in a box of the robot frame: questions to the obstacle map
# (world.obstacles). A count is of points that cameras saw in cells of 10 cm, less what was
# forgotten since (facts-2005 section 4.7); a cell counts as one point, at its middle. Keeps
# nothing. An obstacle that nobody saw in the last seconds is not in it. An argument that is not a
# number is a ValueError: to say that nothing stands there would be wrong.
import math

from lib.geom import from_field

OWN_BODY = 12.0          # cm; what was seen nearer is walked over or the robot itself

Counted = tuple[float, float, float]  # x and y in cm on the field, count


def points_near(world, place, reach) -> list[Counted]:
    """What this robot saw or a teammate reported within so many cm of a place, in x and in y: of a
    map of a hundred cells the behaviours look at a small part."""
    low_x, high_x = place.x - reach, place.x + reach
    low_y, high_y = place.y - reach, place.y + reach
    points = []
    for cell in world.obstacles:
        at = cell.position
        if low_x < at.x < high_x and low_y < at.y < high_y:
            points.append((at.x, at.y, cell.own + cell.heard))
    return points


def in_box(points, pose, left, right, near, far) -> float:
    """The count in a box of the robot frame: x from left to right, y from near to far, in cm."""
    if any(math.isnan(value) for value in (left, right, near, far)):
        raise ValueError('obstacles: an argument is not a number')
    total = 0.0
    for x, y, count in points:
        x, y = from_field(pose, x, y)
        if left <= x <= right and near <= y <= far:
            total += count
    return total
