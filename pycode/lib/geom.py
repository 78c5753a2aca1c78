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


def moved(x, y, odometry) -> Point:
    """Where a resting point of the robot frame is after the robot moved by one frame's odometry.

    The step is taken along half the turn: the chord of an arc, 0.07 % short at 218 deg/s."""
    half = math.radians(0.5 * odometry.turn_deg)
    x += odometry.left * math.cos(half) + odometry.forward * math.sin(half)
    y -= odometry.forward * math.cos(half) - odometry.left * math.sin(half)
    turn = math.radians(odometry.turn_deg)
    return (x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn))


def from_field(pose, x, y) -> Point:
    """A point of the field frame in the frame of a robot at that pose."""
    angle = math.radians(pose.heading_deg)
    dx, dy = x - pose.position.x, y - pose.position.y
    return (dx * math.sin(angle) - dy * math.cos(angle),
            dx * math.cos(angle) + dy * math.sin(angle))
