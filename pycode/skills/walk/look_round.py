# SPDX-License-Identifier: Apache-2.0
# Stands and pans from side to side at two tilts, then turns the body on the spot, and again: with a
# head that reaches 88 deg to either side three turns show all there is around. Keeps the row, how
# far this turn is by odometry, and how many rows and rounds came to an end.
import kelpie
from arbiter.machine import Machine
from lib.head import view


class Look:
    PAN = 86.0  # deg
    PAN_SPEED = 75.0         # deg/s; line points need less than 156
    DOWN = (4.0, 18.0)       # deg of the view below the horizon, in turn
    SETTLE = 0.35            # s until the head has come to a row's beginning
    TURN = 115.0             # deg of the body between two rounds
    TURN_SPEED = 60.0  # deg/s


class LookRound(Machine):
    NAME = 'look_round'

    def __init__(self):
        super().__init__(self.pan)
        self.row = 0        # of the two tilts
        self.rows = 0       # pans that came to an end
        self.rounds = 0     # turns that came to an end
        self.turned = 0.0   # degrees of this turn

    @property
    def turning(self) -> bool:
        return self.state == self.turn

    def pan(self, world) -> kelpie.Command:
        passed = self.since(world) - Look.SETTLE
        way = min(max(0.0, passed) * Look.PAN_SPEED, 2.0 * Look.PAN)
        side = 1.0 if self.row == 0 else -1.0
        if way >= 2.0 * Look.PAN:
            self.end_row(world)
        return kelpie.Command(head=view(side * (Look.PAN - way), Look.DOWN[self.row],
                                        world.stance))

    def end_row(self, world):
        self.rows += 1
        self.row = 1 - self.row
        self.turned = 0.0
        self.enter(world, self.turn if self.row == 0 else self.pan, None, 'row {} is over',
                   self.rows)

    def turn(self, world) -> kelpie.Command:
        self.turned += world.odometry.turn_deg
        if self.turned >= Look.TURN:
            self.rounds += 1
            self.enter(world, self.pan, None, 'turned {} deg', self.turned)
        head = view(Look.PAN, Look.DOWN[0], world.stance)
        return kelpie.Command(head=head, walk=kelpie.WalkRequest(turn_deg=Look.TURN_SPEED))
