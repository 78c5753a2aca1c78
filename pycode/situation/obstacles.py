# SPDX-License-Identifier: Apache-2.0
# What stands in a corridor, box, sector or arc of the field, and which way is free: questions to
# the obstacle map (world.obstacles), to be asked of one frame's points_of(world). A count is of
# points that cameras saw in cells of 10 cm, less what was forgotten since (facts-2005 section 4.7);
# beacons and the walls of goals are taken from world.field. Keeps nothing. An obstacle that nobody
# saw in the last seconds is not in it. Counts take a cell as one point, at its middle; a gap leads
# past its whole square. An argument that is not a number is a ValueError: to say that nothing
# stands there would be wrong.
import math

import kelpie
from lib.geom import TURN, clamp, from_field, heading, wrap

CELL = 10.0              # cm
LANDMARK_COUNT = 40.0    # of each cell's length of a wall or beacon
FULL = 10.0              # a cell with fewer points does not block a way
CORRIDOR = 30.0          # cm, a robot's width and some
GAP_REACH = 50.0         # cm that must be free
GAP_WIDTH = 20.0         # deg
GAP_SIDE = 110.0         # deg from straight ahead; farther off is no way ahead
OWN_BODY = 12.0          # cm; what was seen nearer is walked over or the robot itself

Counted = tuple[float, float, float]  # x and y in cm on the field, count


def points_of(world, own=True, heard=True, landmarks=True) -> list[Counted]:
    """All that stands on the field as far as this robot saw it, a teammate reported it, or the
    field's description says it."""
    points = [(cell.position.x, cell.position.y,
               (cell.own if own else 0.0) + (cell.heard if heard else 0.0))
              for cell in world.obstacles]
    points = [point for point in points if point[2] > 0.0]
    return points + standing(world.field) if landmarks else points


def points_near(world, place, reach) -> list[Counted]:
    """What points_of(world, landmarks=False) has within so many cm of a place, in x and in y: of a
    map of a hundred cells the behaviours look at a small part."""
    low_x, high_x = place.x - reach, place.x + reach
    low_y, high_y = place.y - reach, place.y + reach
    points = []
    for cell in world.obstacles:
        at = cell.position
        if low_x < at.x < high_x and low_y < at.y < high_y:
            points.append((at.x, at.y, cell.own + cell.heard))
    return points


def between(points, start, end, width=CORRIDOR) -> float:
    """The count within half a width (cm) of the straight way from one (x, y) to another."""
    _numbers(*start, *end, width)
    dx, dy = end[0] - start[0], end[1] - start[1]
    length2 = dx * dx + dy * dy or 1.0
    total = 0.0
    for x, y, count in points:
        along = clamp(((x - start[0]) * dx + (y - start[1]) * dy) / length2, 0.0, 1.0)
        ax, ay = x - start[0] - along * dx, y - start[1] - along * dy
        if 4.0 * (ax * ax + ay * ay) <= width * width:
            total += count
    return total


def in_box(points, pose, left, right, near, far) -> float:
    """The count in a box of the robot frame: x from left to right, y from near to far, in cm."""
    _numbers(left, right, near, far)
    total = 0.0
    for x, y, count in points:
        x, y = from_field(pose, x, y)
        if left <= x <= right and near <= y <= far:
            total += count
    return total


def in_sector(points, pose, degrees, width, far, near=OWN_BODY) -> float:
    """The count in a sector about a pose, or in an arc of it: `width` deg about the direction
    `degrees` left of straight ahead, from near to far (cm)."""
    _numbers(degrees, width, far, near)
    return sum(count for away, heading_deg, count in _polar(points, pose)
               if near <= away <= far and abs(wrap(heading_deg - degrees)) <= 0.5 * width)


def nearest(points, pose, degrees, width, count=FULL) -> float:
    """cm from a pose to the nearest cell of that count in a sector, beyond the own body; infinite
    when there is none."""
    _numbers(degrees, width, count)
    return min((away for away, heading_deg, full in _polar(points, pose)
                if full >= count and away >= OWN_BODY
                and abs(wrap(heading_deg - degrees)) <= 0.5 * width), default=math.inf)


def gap(points, pose, degrees, reach=GAP_REACH, width=GAP_WIDTH) -> tuple[float, float] | None:
    """The free way nearest to a direction: its heading and the width of the gap that it leads
    through, in deg in the robot frame; None when all ways ahead are blocked or too narrow."""
    _numbers(degrees, reach, width)
    degrees = wrap(degrees)
    blocked = [_covered(away, heading_deg) for away, heading_deg, count in _polar(points, pose)
               if count >= FULL and OWN_BODY <= away <= reach + 0.5 * CELL]
    ways = [(clamp(degrees, right + 0.5 * width, left - 0.5 * width), left - right)
            for right, left in _free(blocked) if left - right >= width]
    return min(ways, key=lambda way: abs(wrap(way[0] - degrees)), default=None)


def standing(field) -> list[Counted]:
    """Beacons and the walls of goals, a point for every cell's length."""
    points = []
    for landmark in field.landmarks:
        x, y = landmark.position.x, landmark.position.y
        if landmark.kind in (kelpie.GOAL_BLUE, kelpie.GOAL_YELLOW):
            points += _goal(field, x, y)
        else:
            points.append((x, y, LANDMARK_COUNT))
    return points


def _numbers(*arguments):
    if any(math.isnan(value) for value in arguments):
        raise ValueError('obstacles: an argument is not a number')


def _polar(points, pose):
    """Each point's distance from a pose, its heading there and its count."""
    _numbers(pose.position.x, pose.position.y, pose.heading_deg)
    for x, y, count in points:
        x, y = from_field(pose, x, y)
        yield math.hypot(x, y), heading(x, y), count


def _covered(away, heading_deg):
    """The headings, from right to left, behind which a cell lies that is seen at that distance."""
    half = math.degrees(math.asin(min(1.0, CELL / math.sqrt(2.0) / away)))
    return heading_deg - half, heading_deg + half


def _free(blocked):
    """The runs of free headings ahead, from right to left, as their two ends."""
    turned = [(right + turn, left + turn) for right, left in blocked for turn in (-TURN, 0.0, TURN)]
    free_from = -GAP_SIDE
    for right, left in sorted(turned) + [(GAP_SIDE, GAP_SIDE)]:
        end = min(right, GAP_SIDE)
        if end > free_from:
            yield free_from, end
        free_from = max(free_from, left)


def _goal(field, x, y):
    half, depth = 0.5 * field.goal_width, field.goal_depth
    back = y - depth if y < 0.5 * field.length else y + depth
    corners = [(x - half, y), (x - half, back), (x + half, back), (x + half, y)]
    for (ax, ay), (bx, by) in zip(corners, corners[1:]):
        steps = math.ceil(math.hypot(bx - ax, by - ay) / CELL)
        for i in range(steps):
            yield (ax + (bx - ax) * i / steps, ay + (by - ay) * i / steps, LANDMARK_COUNT)
    yield (*corners[-1], LANDMARK_COUNT)
