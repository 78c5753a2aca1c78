# SPDX-License-Identifier: Apache-2.0
# Stands and pans from side to side at two tilts, then turns the body on the spot, and again: with a
# head that reaches 88 deg to either side three turns show all there is around.
import kelpie
from lib.head import view
from lib.tune import Look


class LookRound:
    def __init__(self):
        self.row = 0        # of the two tilts
        self.rows = 0       # pans that came to an end
        self.rounds = 0     # turns that came to an end
        self.turning = False
        self.turned = 0.0   # degrees of this turn
        self.since_s = None

    def tick(self, world):
        if self.since_s is None:
            self.since_s = world.time_s
        return self.turn(world) if self.turning else self.pan(world)

    def pan(self, world):
        passed = world.time_s - self.since_s - Look.SETTLE
        way = min(max(0.0, passed) * Look.PAN_SPEED, 2.0 * Look.PAN)
        side = 1.0 if self.row == 0 else -1.0
        if way >= 2.0 * Look.PAN:
            self.end_row(world)
        return kelpie.Command(head=view(side * (Look.PAN - way), Look.DOWN[self.row],
                                        world.stance))

    def end_row(self, world):
        self.since_s = world.time_s
        self.rows += 1
        self.row = 1 - self.row
        self.turning = self.row == 0
        self.turned = 0.0

    def turn(self, world):
        self.turned += world.odometry.turn_deg
        if self.turned >= Look.TURN:
            self.turning = False
            self.rounds += 1
            self.since_s = world.time_s
        head = view(Look.PAN, Look.DOWN[0], world.stance)
        return kelpie.Command(head=head, walk=kelpie.WalkRequest(turn_deg=Look.TURN_SPEED))
