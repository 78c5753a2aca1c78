# SPDX-License-Identifier: Apache-2.0
# Points and directions in the plane, and the walk in a direction. Keeps nothing. Robot frame: x to
# the right, y ahead, directions in degrees left of ahead. Field: the own goal at y = 0.
import math

import kelpie

FULL = 60.0          # cm/s asked for; the fast walk makes 46 of it
STRAFE = 35.0        # cm/s of the normal walk, in any direction
TURN_GAIN = 3.0      # deg/s per deg
TURN_SPEED = 150.0   # deg/s; the legs could do 235, but then the images smear
FAST_WITHIN = 30.0   # deg off ahead within which the fast walk goes; it cannot strafe as well


def clamp(value, low, high) -> float:
    return max(low, min(high, value))


def wrap(degrees) -> float:
    """The same direction in -180 to 180."""
    return (degrees + 180.0) % 360.0 - 180.0


def between(start, end) -> float:
    """The direction from one point of the field to another, counter-clockwise from +x."""
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


def along(start, degrees, distance) -> tuple:
    """The point of the field so far from a start in that direction."""
    angle = math.radians(degrees)
    return start[0] + distance * math.cos(angle), start[1] + distance * math.sin(angle)


def xy(thing) -> tuple:
    """The place of a robot, of a ball or of a mark of the field."""
    place = getattr(thing, 'pose', thing).position
    return place.x, place.y


def walk(way, face, speed=FULL) -> kelpie.WalkRequest:
    """Goes in the direction `way` and turns to `face`, both left of ahead."""
    turn = clamp(TURN_GAIN * face, -TURN_SPEED, TURN_SPEED)
    ahead, left = speed * math.cos(math.radians(way)), speed * math.sin(math.radians(way))
    if abs(way) < FAST_WITHIN:
        return kelpie.WalkRequest(forward=ahead, left=left, turn_deg=turn, kind=kelpie.WALK_FAST)
    share = min(1.0, STRAFE / max(speed, 1.0))
    return kelpie.WalkRequest(forward=share * ahead, left=share * left, turn_deg=turn)
