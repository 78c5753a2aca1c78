# SPDX-License-Identifier: Apache-2.0
# Looks for a lost ball: a step back if it was at the feet, a scan with the head, a turn on the spot
# towards where it was last believed to be, a walk to somewhere else; then all over again.
import math

import kelpie
from lib.geom import clamp, from_field, heading
from lib.tune import Field, Search
from skills.watch import Scan, Spin, lost_at_feet, search_side


class FindBall:
    def __init__(self, world):
        self.start_s = world.time_s
        self.side = search_side(world)
        self.upper = world.pose.position.y < 0.5 * Field.LENGTH
        self.back_off = Search.BACK_OFF_TIME if lost_at_feet(world) else 0.0
        self.scan = Scan()
        self.spin = Spin()

    def tick(self, world):
        passed = world.time_s - self.start_s
        if passed < self.back_off:
            return kelpie.Command(walk=kelpie.WalkRequest(forward=Search.BACK_OFF_SPEED),
                                  head=self.scan.tick(world, passed))
        passed -= self.back_off
        if passed < Search.SCAN_TIME:
            return kelpie.Command(head=self.scan.tick(world, passed))
        passed -= Search.SCAN_TIME
        if passed < Search.TURN_TIME:
            turn = kelpie.WalkRequest(turn_deg=self.side * Search.TURN_SPEED)
            return kelpie.Command(walk=turn, head=self.spin.tick(world, self.side))
        return self.roam(world, passed - Search.TURN_TIME)

    def roam(self, world, passed):
        """To the middle of one half, and of the other the next time: all of it is in sight then."""
        share = 0.65 if self.upper else 0.35
        x, y = from_field(world.pose, 0.5 * Field.WIDTH, share * Field.LENGTH)
        if passed > Search.ROAM_TIME or math.hypot(x, y) < Search.ROAM_NEAR:
            self.start_s, self.back_off, self.upper = world.time_s, 0.0, not self.upper
        aside = heading(x, y)
        turn = clamp(1.5 * aside, -Search.TURN_SPEED, Search.TURN_SPEED)
        forward = Search.ROAM_SPEED if abs(aside) < 45.0 else 0.0
        walk = kelpie.WalkRequest(forward=forward, turn_deg=turn)
        return kelpie.Command(walk=walk, head=self.scan.tick(world, passed))
