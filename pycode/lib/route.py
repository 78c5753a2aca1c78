# SPDX-License-Identifier: Apache-2.0
# The shortest way through points, by trying every order: 120 for the five of the challenge (thesis
# 2004 section 4.1.5). Time is taken to be proportional to the way; turning is ignored.
import math


def points_of(task):
    """The five points of world.task as (x, y) in cm on the field."""
    return [(task.points[i], task.points[i + 1]) for i in range(0, len(task.points), 2)]


def way(start, order):
    length, here = 0.0, start
    for point in order:
        length += math.hypot(point[0] - here[0], point[1] - here[1])
        here = point
    return length


def orders(points):
    if not points:
        yield []
    for i, first in enumerate(points):
        for rest in orders(points[:i] + points[i + 1:]):
            yield [first] + rest


def shortest(position, points):
    start = (position.x, position.y)
    return min(orders(points), key=lambda order: way(start, order))
