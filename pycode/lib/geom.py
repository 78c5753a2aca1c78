# SPDX-License-Identifier: Apache-2.0
# Plane geometry in cm and degrees. Robot frame: x right, y forward, headings left positive.
# Field frame: x across, y up-field, headings counter-clockwise from +x.
import math


def clamp(value, low, high):
    return max(low, min(high, value))


def wrap(degrees):
    """The same direction in (-180, 180]."""
    turned = math.fmod(degrees, 360.0)
    if turned > 180.0:
        return turned - 360.0
    return turned + 360.0 if turned <= -180.0 else turned


def heading(x, y):
    return math.degrees(math.atan2(-x, y))


def polar(distance, degrees):
    angle = math.radians(degrees)
    return -distance * math.sin(angle), distance * math.cos(angle)


def moved(x, y, odometry):
    """Where a resting point of the robot frame is after the robot has moved."""
    half = math.radians(0.5 * odometry.turn_deg)
    x += odometry.left * math.cos(half) + odometry.forward * math.sin(half)
    y -= odometry.forward * math.cos(half) - odometry.left * math.sin(half)
    turn = math.radians(odometry.turn_deg)
    return (x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn))


def from_field(pose, x, y):
    angle = math.radians(pose.heading_deg)
    dx, dy = x - pose.position.x, y - pose.position.y
    return (dx * math.sin(angle) - dy * math.cos(angle),
            dx * math.cos(angle) + dy * math.sin(angle))
