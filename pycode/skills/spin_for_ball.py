# SPDX-License-Identifier: Apache-2.0
# Turns on the spot for a ball that a scan did not show, the head held ahead of the turn (thesis
# 2006 section 6.2.2, algorithm 6.2). Keeps the side it was begun to and how far it turned by
# odometry. It sees nothing under the chin: the chain steps back first.
import kelpie
from lib.lost_ball import spin_head, spin_speed
from skills.scan_for_ball import head_params


class SpinForBall:
    def __init__(self, side):
        self.side = side
        self.turned = 0.0  # deg

    def command(self, world, distance) -> kelpie.Command:
        """`distance`: cm to where the ball is believed, infinite without such a belief."""
        self.turned += abs(world.odometry.turn_deg)
        return kelpie.Command(head=head_params(*spin_head(distance, self.side)),
                              walk=kelpie.WalkRequest(turn_deg=spin_speed(distance, self.side)))
