# SPDX-License-Identifier: Apache-2.0
# The home of a non-attacker: the place that its role has for the ball (trees or examples, as
# world.task.positions says), moved off the ways that the attacker needs. Keeps the ball on its
# string, the place, and the examples once they are asked. Without any ball the role's own part of
# the field is home.
import math

import kelpie
from decisions import positions, positions_passing, positions_play
from decisions.positions_regression import PLACE, RegressedPositions, attacker_angle, attacks
from lib import rulebook
from lib.paths import attacker_of, bearing_of, point_of
from situation import keep_off

EVERY_FRAMES = 10     # of a regression: 14000 operations of the interpreter


class Home:
    def __init__(self):
        self.string = positions.BallOnString()
        self.regressed = None
        self.frames = 0
        self.passing = None    # the place where a pass may be had
        self.raw = None        # (x, y, heading or None) before the attacker's ways are left free

    def update(self, world, role, ball, lanes) -> tuple:
        """The place on the field for this frame."""
        rules = rulebook.of(world)
        at = self.string.update(ball, positions.STRING if rules.ON_STRING else 0.0)
        self.frames -= 1
        if at is None:
            wide, long = positions.WITHOUT_BALL[role]
            self.raw = wide * world.field.width, long * world.field.length, None
        elif world.task.positions == kelpie.POSITIONS_BY_REGRESSION:
            if self.frames <= 0 or self.raw is None:
                self.frames = EVERY_FRAMES
                self.raw = self.by_examples(world, role, at)
        elif rulebook.follows_play(world):
            self.raw = (*positions_play.place(world, role, ball or at), None)
        else:
            self.raw = (*positions.PLACES[role](world.field, at), None)
        place = self.raw[0], self.raw[1]
        if rulebook.passes(world) and at is not None:
            if self.frames <= 0 or self.passing is None:
                self.frames = EVERY_FRAMES
                self.passing = positions_passing.moved(world, role, place, at, self.passing)
            place = self.passing
        return keep_off.cleared(world.field, place, lanes) if rules.LEAVES_WAYS else place

    def by_examples(self, world, role, ball):
        if self.regressed is None:
            self.regressed = RegressedPositions()
        mate = attacker_of(world)
        attacker = point_of(mate.pose) if mate is not None else ball
        holds = mate is not None and mate.note.grabs == kelpie.HOLDS
        near = [one for one in world.opponents if one.seconds_since_seen < 2.0]
        bit = attacks(ball, attacker, holds, near, world.field)
        return self.regressed.place(world.field, ball, attacker_angle(attacker, ball), bit,
                                    PLACE[role])

    def turn_deg(self, world, ball) -> float:
        """deg to turn to look where who stands there looks: at the ball, but for examples."""
        if self.raw is not None and self.raw[2] is not None:
            there = math.radians(self.raw[2])
            here = point_of(world.pose)
            return bearing_of(world, (here[0] + math.cos(there), here[1] + math.sin(there)))
        return bearing_of(world, ball) if ball is not None else 0.0
