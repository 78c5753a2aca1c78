# SPDX-License-Identifier: Apache-2.0
# Walks to the middle of the other half, the head sweeping: from there all of that half is in sight.
# Keeps which half is next, when it set out, and whether it arrived. Follows the eight steps of the
# search, of which the last sees about 3 m around. As wrong as the pose; knows no obstacles.
import math

import kelpie
from lib.geom import from_field
from lib.steer import towards
from skills.scan_for_ball import ScanForBall

UPPER, LOWER = 0.65, 0.35  # shares of the field's length
NEAR = 30.0                # cm
LONGEST = 9.0              # s


class Roam:
    def __init__(self, world):
        self.upper = world.pose.position.y < 0.5 * world.field.length
        self.begun_s = None  # None: not on the way
        self.scan = ScanForBall()

    def done(self, world) -> bool:
        """Whether it has arrived, or will not; asked again, it sets out for the other half."""
        if self.begun_s is None:
            self.begun_s = world.time_s
        late = world.time_s - self.begun_s > LONGEST
        if late or math.hypot(*self.goal(world)) < NEAR:
            self.begun_s, self.upper = None, not self.upper
            return True
        return False

    def goal(self, world):
        share = UPPER if self.upper else LOWER
        return from_field(world.pose, 0.5 * world.field.width, share * world.field.length)

    def command(self, world) -> kelpie.Command:
        return kelpie.Command(walk=towards(self.goal(world)), head=self.scan.head(world))
