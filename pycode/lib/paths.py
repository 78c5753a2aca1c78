# SPDX-License-Identifier: Apache-2.0
# Curved ways round others, by what stands on the field: an arc from here to there is given by its
# bend, the degrees by which it begins left of the straight line. Keeps nothing. An arc is taken for
# a parabola, 2 % of its length off at 60 deg. Everybody is taken to stand still.
import math

import kelpie
from lib.geom import wrap

CLEAR = 34.0        # cm from a robot's middle to the way: two bodies 20 wide and 4 of the pose
BENDS = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0, 65.0, -65.0)  # deg
OVERLAP = 3.0       # deg of bend that 1 cm nearer than CLEAR costs
SWITCH = 25.0       # deg that passing on the other side than before must be better by
OFF_FIELD = 120.0   # deg, of an arc that leaves the field
EDGE = 15.0         # cm
FULL = 10.0         # count of an obstacle cell: one with fewer points blocks no way
SEEN_S = 2.0        # s; of opponents
OWN_BODY = 14.0     # cm; what is nearer is the robot itself
SILENT_S = 1.5      # a mate's pose expires after 45 frames (facts-2005 section 8.2)


def others(world) -> list:
    """Where on the field somebody stands or the ball lies, and the own box, where nobody walks."""
    points = [(mate.pose.position.x, mate.pose.position.y) for mate in world.teammates]
    points += [(one.position.x, one.position.y) for one in world.opponents
               if one.seconds_since_seen < SEEN_S]
    points += [(cell.position.x, cell.position.y) for cell in world.obstacles
               if cell.own + cell.heard >= FULL]
    if world.ball.present and world.ball.seconds_since_seen < SEEN_S:
        points.append(point_of(world.ball))
    return points + box(world.field)


def box(field) -> list:
    """The front of the own box, and its sides."""
    half, middle = 0.5 * field.box_width, 0.5 * field.width
    low, front = 0.5 * field.box_depth, field.box_depth - CLEAR / 2.0
    return [(middle - half + CLEAR / 2.0, low), (middle + half - CLEAR / 2.0, low),
            (middle - half + CLEAR / 2.0, front), (middle, front),
            (middle + half - CLEAR / 2.0, front)]


def along(points, start, end) -> list:
    """Of the points on the way: (share of the way, cm to the left of the straight line)."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = max(math.hypot(dx, dy), 1.0)
    dx, dy = dx / length, dy / length
    found = []
    for x, y in points:
        x, y = x - start[0], y - start[1]
        ahead, left = x * dx + y * dy, y * dx - x * dy
        if 0.0 < ahead < length - 0.5 * CLEAR and abs(left) < CLEAR + 0.7 * length and \
                x * x + y * y > OWN_BODY * OWN_BODY:
            found.append((ahead / length, left))
    return found


def best_bend(points, start, end, field, before=0.0) -> float:
    """The bend of the way that is freest and least bent; `before`: of the way walked so far."""
    length = math.hypot(end[0] - start[0], end[1] - start[1])
    on_way = along(points, start, end)
    if not on_way:
        return 0.0

    def cost(bend):
        rise = 2.0 * length * math.tan(math.radians(0.5 * bend))
        total = abs(bend) + (SWITCH if bend * before < 0.0 else 0.0)
        for share, left in on_way:
            gap = abs(left - rise * share * (1.0 - share))
            if gap < CLEAR:
                total += OVERLAP * (CLEAR - gap)
        return total + (0.0 if stays_on(field, start, end, rise) else OFF_FIELD)
    return min(BENDS, key=cost)


def stays_on(field, start, end, rise) -> bool:
    """Whether the middle of an arc is on the field; `rise`: four times its height in cm."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = max(math.hypot(dx, dy), 1.0)
    x = 0.5 * (start[0] + end[0]) - 0.25 * rise * dy / length
    y = 0.5 * (start[1] + end[1]) + 0.25 * rise * dx / length
    return EDGE <= x <= field.width - EDGE and EDGE <= y <= field.length - EDGE


def bearing_of(world, point) -> float:
    """deg left of straight ahead to a point of the field; 0 for None."""
    if point is None:
        return 0.0
    place = world.pose.position
    return wrap(math.degrees(math.atan2(point[1] - place.y, point[0] - place.x)) -
                world.pose.heading_deg)


def goal_of(field):
    """The opponents' goal line's middle."""
    return 0.5 * field.width, field.length


def point_of(what) -> tuple:
    """The place of a pose, a ball or a cell."""
    place = what.position
    return place.x, place.y


def attacker_of(world):
    """The mate that attacks, the first to be at the ball if there are two; None without."""
    return min((mate for mate in world.teammates
                if mate.note.role == kelpie.ATTACKER and mate.seconds_since_heard < SILENT_S),
               key=lambda mate: mate.note.time_to_ball, default=None)
