# SPDX-License-Identifier: Apache-2.0
# The shortest way through points of the field, by trying every order: 120 for the five of the
# challenge (thesis 2004 section 4.1.5). Keeps nothing. Time is taken to be proportional to the
# length of the way; it fails to count the turns. Seven points would already be 5040 orders.
import math

from lib.geom import Point


def points_of(task) -> list[Point]:
    """The five points of world.task in cm on the field."""
    return [(task.points[i], task.points[i + 1]) for i in range(0, len(task.points), 2)]


def way(start, order) -> float:
    """Length in cm of the way from a point through the others in that order."""
    length, here = 0.0, start
    for point in order:
        length += math.hypot(point[0] - here[0], point[1] - here[1])
        here = point
    return length


def orders(points):
    """Yields every order of the points, as lists."""
    if not points:
        yield []
    for i, first in enumerate(points):
        for rest in orders(points[:i] + points[i + 1:]):
            yield [first] + rest


def shortest(position, points) -> list[Point]:
    """The order with the shortest way from a position, which has members x and y."""
    start = (position.x, position.y)
    return min(orders(points), key=lambda order: way(start, order))
