# SPDX-License-Identifier: Apache-2.0
# Who runs, and where the others go: who would have the ball first runs, the nearer to the own goal
# of the other two keeps between it and the ball, the third goes along beside and behind, ready for
# a ball that slips off. Keeps the role. Fails where radio does: then two run for a while.
import math

import kelpie
from plane import along, between, clamp, walk, wrap, xy

SPEED, TURN = 42.0, 200.0   # cm/s and deg/s, and
ROUND_S = 0.9        # s for half a circle round the ball: what a robot needs to be behind it
STAYS_S = 0.4        # s by which another must be sooner than who runs
SILENT_S = 1.5       # s after which a mate no longer counts
BESIDE, BACK = 45.0, 55.0   # cm of the supporter's place from the ball
DEFENDS = 0.45       # of the way from the ball to the own goal
MOST = 190.0         # cm of that way: the defender follows the play
SWAY, SWAY_S = 22.0, 3.2    # cm and s: who waits steps to and fro, since a start takes 0.5 s
BOX = 24.0           # cm round the own box, which is its goalie's alone
CLEAR = 42.0         # cm within which others are walked round
# Places at a kick-off: shares of the width from the middle, and of the length.
OURS = {1: (0.0, 0.04), 2: (0.0, 0.415), 3: (-0.2, 0.22), 4: (0.27, 0.42)}
THEIRS = {1: (0.0, 0.04), 2: (-0.13, 0.39), 3: (0.05, 0.2), 4: (0.22, 0.4)}


def seconds_to(world, ball) -> float:
    """Until it runs with the ball: the way, the turn, and round the ball to be behind it."""
    here = xy(world.pose)
    bearing = between(here, ball)
    goal = between(ball, (0.5 * world.field.width, world.field.length))
    return (math.dist(here, ball) / SPEED + abs(wrap(bearing - world.pose.heading_deg)) / TURN +
            ROUND_S * abs(wrap(goal - bearing)) / 180.0)


class Roles:
    def __init__(self):
        self.role, self.seconds = kelpie.ATTACKER, 1000.0

    def choose(self, world, ball) -> int:
        others = [mate for mate in world.teammates if mate.seconds_since_heard < SILENT_S and
                  mate.note.role not in (kelpie.KEEPER, kelpie.NO_ROLE)]
        self.seconds = 1000.0 if ball is None else seconds_to(world, ball)
        if self.role == kelpie.ATTACKER:
            self.seconds = max(0.0, self.seconds - STAYS_S)
        first = min(((mate.note.time_to_ball, mate.player) for mate in others),
                    default=(math.inf, 0))
        if (self.seconds, world.game.player) < first:
            self.role = kelpie.ATTACKER
            return self.role
        goal = 0.5 * world.field.width, 0.0
        here = math.dist(xy(world.pose), goal) - (20.0 if self.role == kelpie.DEFENDER else 0.0)
        deeper = all(here < math.dist(xy(mate.pose), goal) for mate in others
                     if mate.player != first[1])
        self.role = kelpie.DEFENDER if deeper and len(others) > 1 else kelpie.SUPPORTER
        return self.role


def out_of_box(field, point, margin=BOX) -> tuple:
    """The point, or the nearest to it that far outside the own box."""
    x, y = point
    half, deep = 0.5 * field.box_width + margin, field.box_depth + margin
    beside = abs(x - 0.5 * field.width)
    if beside >= half or y >= deep:
        return point
    if half - beside < deep - y and half < 0.5 * field.width - 15.0:
        return 0.5 * field.width + math.copysign(half, x - 0.5 * field.width), y
    return x, deep


def support(world, ball) -> tuple:
    """Beside the ball on the field's inner side, and behind it."""
    inner = 1.0 if ball[0] < 0.5 * world.field.width else -1.0
    return ball[0] + inner * BESIDE, ball[1] - BACK


def defence(world, ball) -> tuple:
    goal = 0.5 * world.field.width, 0.0
    return along(ball, between(ball, goal), min(DEFENDS * math.dist(ball, goal), MOST))


def moving(world, place, ball) -> tuple:
    """The place, swayed across the way to the ball."""
    sway = SWAY * math.sin(2.0 * math.pi * world.time_s / SWAY_S + world.game.player)
    x, y = along(place, between(place, ball) + 90.0, sway)
    return out_of_box(world.field, (clamp(x, 20.0, world.field.width - 20.0),
                                    clamp(y, 20.0, world.field.length - 20.0)))


def ready(world) -> tuple:
    """Where a player stands at a kick-off: in its half, and who waits out of the circle, too."""
    x, y = (OURS if world.game.kick_off else THEIRS)[world.game.player]
    return (0.5 + x) * world.field.width, y * world.field.length


def go(world, place, watched, fast=4.0):
    """Walks to a place, round others, and looks from near by at what it watches. `fast`: cm/s for
    each cm that is left."""
    here, facing = xy(world.pose), world.pose.heading_deg
    away, bearing, push = math.dist(here, place), between(here, place), 0.0
    for other in list(world.opponents) + list(world.teammates):
        gap, off = math.dist(here, xy(other)), wrap(between(here, xy(other)) - bearing)
        if gap < min(CLEAR, away) and abs(off) < 75.0:
            push = -math.copysign(70.0 * (1.2 - gap / CLEAR), off)
    way = wrap(bearing + push - facing)
    near = away < 45.0
    face = wrap(between(here, watched) - facing) if near else way
    return walk(way, face, min(60.0, fast * away) if near or abs(way) < 60.0 else 8.0)
