# SPDX-License-Identifier: Apache-2.0
# Plane geometry in cm and degrees. Robot frame: x right, y forward, headings left positive.
# Field frame: x across, y up-field, headings counter-clockwise from +x. Keeps nothing.
import math

TURN = 360.0  # deg, once round
Point = tuple[float, float]  # x, y in cm, in the robot frame unless its name says otherwise


def clamp(value, low, high) -> float:
    return max(low, min(high, value))


def wrap(degrees) -> float:
    """The same direction in (-180, 180]."""
    if -180.0 < degrees <= 180.0:
        return degrees
    turned = math.fmod(degrees, TURN)
    if turned > 180.0:
        return turned - TURN
    return turned + TURN if turned <= -180.0 else turned


def heading(x, y) -> float:
    """Degrees left of straight ahead to a point of the robot frame."""
    return math.degrees(math.atan2(-x, y))


def polar(distance, degrees) -> Point:
    """The point of the robot frame at that distance (cm) and heading; the inverse of heading()."""
    angle = math.radians(degrees)
    return -distance * math.sin(angle), distance * math.cos(angle)


def moved(x, y, odometry, times=1) -> Point:
    """Where a resting point of the robot frame is after the robot moved by one frame's odometry,
    or by as much several times.

    The step is taken along half the turn: the chord of an arc, at 218 deg/s 0.07 % short of one
    frame's and 1 % of four frames' arc."""
    forward, left = times * odometry.forward, times * odometry.left
    turn = math.radians(times * odometry.turn_deg)
    sine, cosine = math.sin(0.5 * turn), math.cos(0.5 * turn)
    x += left * cosine + forward * sine
    y -= forward * cosine - left * sine
    sine, cosine = math.sin(turn), math.cos(turn)
    return x * cosine + y * sine, y * cosine - x * sine


def frame_of(pose) -> tuple[float, float, float, float]:
    """A robot's place on the field with the sine and cosine of its heading, for in_frame()."""
    angle, place = math.radians(pose.heading_deg), pose.position
    return place.x, place.y, math.sin(angle), math.cos(angle)


def in_frame(frame, x, y) -> Point:
    """A point of the field frame in the frame of the robot of frame_of()."""
    dx, dy = x - frame[0], y - frame[1]
    return dx * frame[2] - dy * frame[3], dx * frame[3] + dy * frame[2]


def to_field(pose, x, y) -> Point:
    """A point of the robot frame in the field frame."""
    px, py, sine, cosine = frame_of(pose)
    return px + x * sine + y * cosine, py - x * cosine + y * sine


def from_field(pose, x, y) -> Point:
    """The same for one point; who has many asks for the frame once."""
    return in_frame(frame_of(pose), x, y)
