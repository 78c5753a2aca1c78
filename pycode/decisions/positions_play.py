# SPDX-License-Identifier: Apache-2.0
# Where who does not play the ball goes so that the play never leaves it behind
# (POSITIONS_BY_PLAY; ours): the defender between ball and own goal, everybody else beside the ball
# and behind it, where a ball comes out that the attacker loses. Nobody stands: the place sways to
# and fro, since a start takes half a second. Plain functions from a ball on the field to a place on
# it, in cm. They keep nothing and know no other robot.
import math

import kelpie
from lib.geom import clamp
from lib.goalie_places import direction

CONSTANTS = kelpie.constants.positions  # behaviour/constants.toml: defaults and ranges
BESIDE = CONSTANTS.beside    # cm from the ball towards the field's middle,
BACK = CONSTANTS.back        # cm behind it
DEFENDS = CONSTANTS.defends  # of the way from the ball to the own goal,
MOST = CONSTANTS.most        # cm of it: the defender follows the play
SWAY = CONSTANTS.sway        # cm to each side, across the way to the ball
SWAY_S = 3.2         # s there and back: 22 cm to each side are walked at 30 cm/s
EDGE = 20.0          # cm from the lines
BOX = 24.0           # cm round the own box, which is its goalie's alone: half a robot, and the sway


def support(field, ball) -> tuple:
    """Beside the ball on the field's inner side, and behind it."""
    inner = 1.0 if ball[0] < 0.5 * field.width else -1.0
    return ball[0] + inner * BESIDE, ball[1] - BACK


def defence(field, ball) -> tuple:
    """On the way from the ball to the own goal's middle."""
    goal = 0.5 * field.width, 0.0
    share = min(DEFENDS, MOST / max(math.dist(ball, goal), 1.0))
    return ball[0] + share * (goal[0] - ball[0]), ball[1] + share * (goal[1] - ball[1])


def swayed(world, place, ball) -> tuple:
    """The place, moved across the way to the ball; mates sway at different times."""
    turns = world.time_s / SWAY_S + world.game.player / 4.0
    angle = math.radians(direction(place, ball) + 90.0)
    off = SWAY * math.sin(2.0 * math.pi * turns)
    return out_of_box(world.field, (
        clamp(place[0] + off * math.cos(angle), EDGE, world.field.width - EDGE),
        clamp(place[1] + off * math.sin(angle), EDGE, world.field.length - EDGE)))


def out_of_box(field, point) -> tuple:
    """The point, or the nearest to it that lies BOX outside the own box."""
    x, y = point
    half, deep = 0.5 * field.box_width + BOX, field.box_depth + BOX
    middle = 0.5 * field.width
    beside = abs(x - middle)
    if beside >= half or y >= deep:
        return point
    if half - beside < deep - y and half < middle - EDGE:
        return middle + math.copysign(half, x - middle), y
    return x, deep


def place(world, role, ball) -> tuple:
    """Of a role in this frame."""
    at = defence(world.field, ball) if role == kelpie.DEFENDER else support(world.field, ball)
    return swayed(world, at, ball)
