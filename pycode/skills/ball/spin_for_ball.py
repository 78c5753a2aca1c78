# SPDX-License-Identifier: Apache-2.0
# Turns on the spot for a ball that a scan did not show, the head held ahead of the turn (thesis
# 2006 section 6.2.2, algorithm 6.2). Keeps the side it was begun to and how far it turned by
# odometry. It sees nothing under the chin: the chain steps back first.
import math

import kelpie
from arbiter.skill import Skill
from skills.ball.lost_ball import MAX_PAN, spin_head, spin_speed
from skills.head.scan_for_ball import head_params


class SpinForBall(Skill):
    NAME = 'spin_for_ball'

    def __init__(self, memory, side, times=1.0):
        """`times`: as fast as the algorithm's speed."""
        self.memory = memory
        self.side = side
        self.times = times
        self.turned = 0.0  # deg

    def step(self, world, asked=(math.inf, 0.0)) -> kelpie.Command:
        """`asked`: cm to where the ball is believed, infinite without such a belief; and deg of
        turning to the next direction that was not looked at: the head goes on to there."""
        distance, unseen = asked
        self.memory.spun(self.side)
        self.turned += abs(world.odometry.turn_deg)
        pan, tilt, crane = spin_head(distance, self.side)
        pan = self.side * max(abs(pan), min(unseen, MAX_PAN))
        return kelpie.Command(head=head_params(pan, tilt, crane),
                              walk=kelpie.WalkRequest(turn_deg=self.times *
                                                      spin_speed(distance, self.side)))
