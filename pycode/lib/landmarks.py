# SPDX-License-Identifier: Apache-2.0
# Active localisation's choice: which beacon or goal a short look of the head would help most, and
# how the head looks at it (thesis 2006 section 4.3.2; distances and limits of facts-2005 section
# 7.2). The pose is least sure along the widest axis of its covariance; a landmark in line with that
# axis is measured along it. Keeps nothing. A wrong pose makes it look where no landmark is.
import math

import kelpie
from lib.geom import frame_of, from_field, heading, in_frame, wrap

ATTACKER_PAN = 70.0   # deg to either side
GOALIE_PAN = 80.0  # deg
NEAREST = 70.0        # cm; a nearer one does not fit into the image
FARTHEST = 550.0  # cm
RAISE_BELOW = 120.0   # cm; a nearer beacon is looked at in its upper half, where the colours are
ROUND = 1.2           # standard deviations this alike have no widest axis
GOALS = (kelpie.GOAL_BLUE, kelpie.GOAL_YELLOW)


def widest_axis(covariance) -> tuple[float, float]:
    """The direction (deg on the field, of a line, in (-90, 90]) in which a position is least sure,
    and how many times wider it is there than across. `covariance`: row by row, x and y first, of
    2 x 2 or 3 x 3."""
    side = 3 if len(covariance) == 9 else 2
    xx, xy, yy = covariance[0], covariance[1], covariance[side + 1]
    middle, half = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
    narrow = max(middle - half, 1e-9)
    return (math.degrees(0.5 * math.atan2(2.0 * xy, xx - yy)),
            math.sqrt(max(middle + half, narrow) / narrow))


def off_axis(direction, axis) -> float:
    """Degrees between a direction and a line, at most 90."""
    apart = abs(wrap(direction - axis))
    return min(apart, 180.0 - apart)


def in_reach(world, pan_limit):
    """Yields each landmark that the head can look at, its place in the robot frame and its
    heading."""
    frame = frame_of(world.pose)
    for mark in world.field.landmarks:
        place = mark.position
        x, y = in_frame(frame, place.x, place.y)
        pan = heading(x, y)
        if abs(pan) <= pan_limit and NEAREST <= math.hypot(x, y) <= FARTHEST:
            yield mark, (x, y), pan


def choose_landmark(world, pan_limit=ATTACKER_PAN, turned_from=0.0):
    """The landmark of world.field to look at, or None when the head reaches none.

    A beacon before a goal, since a goal's distance is the worse measured one. Among beacons the one
    along the widest axis of the pose; when no axis is wider, the one nearest to the direction
    `turned_from` (deg), where the head is now."""
    axis, wider = widest_axis(world.covariance)

    def cost(candidate):
        mark, _, pan = candidate
        off_deg = abs(pan - turned_from)
        if wider >= ROUND:
            off_deg = off_axis(world.pose.heading_deg + pan, axis)
        return mark.kind in GOALS, off_deg

    best = min(in_reach(world, pan_limit), key=cost, default=None)
    return best[0] if best is not None else None


def look_at_landmark(world, mark) -> kelpie.HeadRequest:
    """The head at a landmark of world.field, as far as it turns."""
    x, y = from_field(world.pose, mark.position.x, mark.position.y)
    high = world.field.goal_height if mark.kind in GOALS else world.field.beacon_height
    share = 0.75 if math.hypot(x, y) < RAISE_BELOW else 0.5
    return kelpie.HeadRequest(aim=kelpie.AIM_POINT,
                              target=kelpie.Point3(x=x, y=y, z=share * high))
