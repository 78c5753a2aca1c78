# SPDX-License-Identifier: Apache-2.0
# Walks to a ball in the goal box or at its edge so that a clearing kick hits it (thesis 2006
# section 4.3.1), to the stand that situation/kick_stand.py chose. Keeps the stand that it went to
# last. Fails in scrums, where the ball moves with whoever pushes it.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, from_field, wrap
from lib.paths import point_of
from safety import own_box

GAIN = 3.0          # cm/s per cm
WALK = 34.0         # cm/s
TURN_GAIN = 3.0     # deg/s per deg
TURN = 150.0        # deg/s
STAND_OFF = 4.0     # cm more from the ball until side and heading fit:
SIDE_FIRST = 4.0    # cm to the side,
TURN_FIRST = 25.0   # deg


class AttackBall(Skill):
    NAME = 'attack_ball'

    def __init__(self):
        self.stand = None

    def step(self, world, stand) -> kelpie.WalkRequest:
        """To the stand, but not up to the ball before side and heading fit."""
        self.stand = stand
        ball = point_of(world.ball)
        turn = wrap(stand.heading - world.pose.heading_deg)
        x, y = from_field(world.pose, *stand.back(ball, 0.0))
        if abs(turn) > TURN_FIRST or abs(x) > SIDE_FIRST:
            back_y = from_field(world.pose, *stand.back(ball, STAND_OFF))[1]
            y = back_y if back_y > 0.0 else min(y, 0.0)
        pace = min(1.0, WALK / max(GAIN * math.hypot(x, y), 1e-6))
        rate = clamp(TURN_GAIN * turn, -TURN, TURN)
        return own_box.inside(world, kelpie.WalkRequest(forward=pace * GAIN * y,
                                                        left=-pace * GAIN * x, turn_deg=rate))

    def explain(self, trace) -> None:
        if self.stand is not None:
            trace.append((kelpie.LAYER_SKILL, self.NAME, 'walk',
                          'the ball shall go to {} deg, kicked from ({}, {})',
                          self.stand.direction, self.stand.x, self.stand.y))
