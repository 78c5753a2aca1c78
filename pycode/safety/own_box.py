# SPDX-License-Identifier: Apache-2.0
# The own box, by the rule that one robot defends there (checklist K07): its goalie does not leave
# it, everybody else does not enter it. Keeps nothing. It is as wrong about the box as the pose.
import math

import kelpie
from lib import rulebook
from lib.geom import clamp
from lib.goalie_places import MARGIN, box, to_field, to_robot
from lib.paths import point_of

SPEED = 34.0         # cm/s; the walk does 36 to 38 (docs/physical-body.md)
SECONDS = 0.35       # to an edge of the box at least: the legs follow late
OUTSIDE = 10.0       # cm that the neck base of another stays away from the box,
AT_BALL = 6.0        # cm of who plays a ball beside it,
AT_RUN = 14.0        # cm of who runs with one, and
RUN_SECONDS = 0.6    # s to an edge: the fast walk stops later
NEAR = 45.0          # cm beyond that from which it minds: what the fast walk goes in a second
ROUND = 8.0          # cm around the box that a way round it keeps free, as the pose is off,
OUT = 8.0            # cm beyond that it leads,
AT_CORNER = 14.0     # cm from a corner that is turned,
STEP = 12.0          # cm between two points of a way that are looked at
KEPT_FREE = 28.0     # cm around the box; a head and paws reach 18 ahead of the neck, the trunk 20
                     # behind it


def kept_in_box(field, pose, forward, left, margin, seconds) -> tuple[float, float]:
    """A wished velocity, slowed towards each edge of the box less a margin so that it takes at
    least that many seconds to get there; beyond an edge it leads back."""
    x, y = to_field(pose.heading_deg, forward, left)
    west, east, south, north = box(field, margin)
    at_x, at_y = pose.position.x, pose.position.y
    x = clamp(x, (west - at_x) / seconds, (east - at_x) / seconds)
    y = clamp(y, (south - at_y) / seconds, (north - at_y) / seconds)
    return to_robot(pose.heading_deg, x, y)


def inside(world, walk, margin=MARGIN) -> kelpie.WalkRequest:
    """The walk, slowed so that the neck base stays in the goal box, that margin (cm) inside."""
    forward, left = kept_in_box(world.field, world.pose, walk.forward, walk.left, margin, SECONDS)
    share = min(1.0, SPEED / max(math.hypot(forward, left), 1e-6))
    return kelpie.WalkRequest(forward=share * forward, left=share * left, turn_deg=walk.turn_deg,
                              kind=walk.kind)


def straight_back(now, walk) -> kelpie.WalkRequest:
    """The filter of a step back: as far as the goal line, straight or not at all. Sideways, as the
    box may ask, its legs take the ball along."""
    walk.forward = min(inside(now.world, walk, 0.0).forward, 0.0)
    return walk


def clear_of(field, margin=KEPT_FREE) -> tuple[float, float, float]:
    """What is kept free: left and right x, and the y below which it lies."""
    half = 0.5 * field.box_width + margin
    return 0.5 * field.width - half, 0.5 * field.width + half, field.box_depth + margin


def held_off(left, right, top, x, y, vx, vy, seconds=1.0) -> tuple[float, float]:
    """No speed towards a side that is within reach of so many seconds."""
    if y < top:
        if x <= left:
            vx = min(vx, (left - x) / seconds)
        elif x >= right:
            vx = max(vx, (right - x) / seconds)
    elif left < x < right:
        vy = max(vy, (top - y) / seconds)
    return vx, vy


def no_deeper(left, right, top, x, y, vx, vy) -> tuple[float, float]:
    """Of who is inside: no speed away from the side that is nearest."""
    away = min(x - left, right - x, top - y)
    if away == top - y:
        return vx, max(vy, 0.0)
    return (min(vx, 0.0) if away == x - left else max(vx, 0.0)), vy


def round_box(field, here, place) -> tuple:
    """Where to go first on a way round the own box: a corner of what is kept free, out of it for
    who is inside, or the place itself."""
    left, right, top = clear_of(field, ROUND)
    x, y = here
    if y < top and left < x < right:
        away = min(x - left, right - x, top - y)
        if away == top - y:
            return x, top + OUT
        return (left - OUT if away == x - left else right + OUT), y
    if not crosses(left, right, top, here, place):
        return place
    corners = (left - OUT, top + OUT), (right + OUT, top + OUT)

    def length(first, second):
        total = math.dist(here, first)
        if crosses(left, right, top, here, first):
            return math.inf
        if not crosses(left, right, top, first, place):
            return total + math.dist(first, place)
        return total + math.dist(first, second) + math.dist(second, place)
    one, other = sorted(corners, key=lambda corner: length(corner, corners[corner == corners[0]]))
    return other if math.dist(here, one) < AT_CORNER else one


def crosses(left, right, top, start, end) -> bool:
    """Whether a straight way leads through what is kept free; looked at every STEP."""
    if start[1] >= top and end[1] >= top:
        return False
    count = math.ceil(math.dist(start, end) / STEP)
    return any(left < start[0] + i * (end[0] - start[0]) / count < right and
               start[1] + i * (end[1] - start[1]) / count < top for i in range(1, count))


def outside_box(now, walk) -> kelpie.WalkRequest:
    """The filter of everybody else: no speed that would lead into the own box within a second. Who
    is inside already walks on as it is."""
    left, right, top = clear_of(now.world.field, OUTSIDE)
    x, y = point_of(now.world.pose)
    if y > top + NEAR or (left < x < right and y < top):
        return walk
    vx, vy = to_field(now.world.pose.heading_deg, walk.forward, walk.left)
    vx, vy = held_off(left, right, top, x, y, vx, vy)
    walk.forward, walk.left = to_robot(now.world.pose.heading_deg, vx, vy)
    return walk


def ball_outside_box(now, walk) -> kelpie.WalkRequest:
    """The filter of who plays the ball or holds it: as far as the box, at full speed for a ball
    that lies before it, and back out of it."""
    runs = rulebook.runs(now.world)
    left, right, top = clear_of(now.world.field, AT_RUN if runs else AT_BALL)
    x, y = point_of(now.world.pose)
    if y > top + NEAR:
        return walk
    asked = to_field(now.world.pose.heading_deg, walk.forward, walk.left)
    if left < x < right and y < top:
        allowed = no_deeper(left, right, top, x, y, *asked)
    else:
        allowed = held_off(left, right, top, x, y, *asked, RUN_SECONDS if runs else SECONDS)
    if allowed != asked:
        walk.forward, walk.left = to_robot(now.world.pose.heading_deg, *allowed)
    return walk
