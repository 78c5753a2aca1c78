# SPDX-License-Identifier: Apache-2.0
# Runs to a place of the field that moves with the play: at full speed ahead while it is far, in any
# direction with the ball in view when it is near. Whoever stands ahead is passed on the side that
# is nearer to the way, and the own box is gone round. Keeps how far it is, for the trace. It minds
# only who is near and ahead: a wall of robots is not gone round.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import FULL, TURNS_FIRST, any_way
from safety import own_box

CLEAR = 42.0         # cm within which others are gone round,
BESIDE_DEG = 75.0    # deg off the way, and
PUSH_DEG = 70.0      # deg that the way turns for who is that near
NEAR = 45.0          # cm from the place, from where on it looks at the ball
GAIN = 4.0           # cm/s for each cm that is left
SLOWLY = 8.0         # cm/s of who has to turn first: the legs go fast only ahead


class RunTo(Skill):
    NAME = 'run_to'

    def __init__(self):
        self.away = 0.0
        self.near = False

    def step(self, world, asked) -> kelpie.WalkRequest:
        """`asked`: the place, and where to look when near, both on the field."""
        place, watched = asked
        here, facing = point_of(world.pose), world.pose.heading_deg
        self.away = math.dist(here, place)
        first = own_box.round_box(world.field, here, place)
        way = wrap(direction(here, first) + past(world, here, first, watched) - facing)
        self.near = self.away < NEAR
        face = wrap(direction(here, watched) - facing) if self.near and watched else way
        slow = not self.near and abs(way) >= TURNS_FIRST
        return any_way(way, face, SLOWLY if slow else min(FULL, GAIN * self.away))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, 'near' if self.near else 'far',
                      '{} cm to go', self.away))


def past(world, here, place, ball=None) -> float:
    """Degrees that the way turns for the last of those who stand near and ahead, or for the ball,
    which another plays and who runs to a place behind it would take home."""
    away, bearing, turn = math.dist(here, place), direction(here, place), 0.0
    robots = list(world.opponents) + [mate.pose for mate in world.teammates]
    for other in [point_of(robot) for robot in robots] + ([ball] if ball else []):
        gap = math.dist(here, other)
        off = wrap(direction(here, other) - bearing)
        if gap < min(CLEAR, away) and abs(off) < BESIDE_DEG:
            turn = -math.copysign(PUSH_DEG * (1.2 - gap / CLEAR), off)
    return turn
