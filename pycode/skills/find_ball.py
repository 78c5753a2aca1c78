# SPDX-License-Identifier: Apache-2.0
# Looks for a lost ball: a step back if it was at the feet, a scan with the head, a turn on the spot
# towards where it was last believed to be, a walk to somewhere else; then all over again. Keeps
# when the round began and which half of the field comes next, from the last belief in ball and
# pose. Has no end of its own: the player leaves it when the ball is seen.
import math

import kelpie
from lib.geom import clamp, from_field, heading
from lib.tune import Search
from skills.watch import Scan, Spin

UPPER, LOWER = 0.65, 0.35  # where to roam to, as shares of the field's length
TURN_GAIN = 1.5            # deg/s per deg
WALK_WITHIN = 45.0         # deg; a place farther to a side is turned to on the spot


def search_side(world) -> float:
    """The side on which the ball was last believed to be: +1 left, -1 right."""
    return 1.0 if world.ball.heading_deg >= 0.0 else -1.0


def lost_at_feet(world) -> bool:
    return world.ball.present and world.ball.distance < Search.BACK_OFF_NEAR


class FindBall:
    def __init__(self, world):
        self.start_s = world.time_s
        self.side = search_side(world)
        self.upper = world.pose.position.y < 0.5 * world.field.length
        self.back_off = Search.BACK_OFF_TIME if lost_at_feet(world) else 0.0
        self.scan = Scan()
        self.spin = Spin()

    def command(self, world) -> kelpie.Command:
        passed = world.time_s - self.start_s
        if passed < self.back_off:
            return kelpie.Command(walk=kelpie.WalkRequest(forward=Search.BACK_OFF_SPEED),
                                  head=self.scan.head(world, passed))
        passed -= self.back_off
        if passed < Search.SCAN_TIME:
            return kelpie.Command(head=self.scan.head(world, passed))
        passed -= Search.SCAN_TIME
        if passed < Search.TURN_TIME:
            turn = kelpie.WalkRequest(turn_deg=self.side * Search.TURN_SPEED)
            return kelpie.Command(walk=turn, head=self.spin.head(world, self.side))
        passed -= Search.TURN_TIME
        return kelpie.Command(walk=self.roam(world, passed), head=self.scan.head(world, passed))

    def roam(self, world, passed) -> kelpie.WalkRequest:
        """To the middle of one half, and of the other the next time: all of it is in sight then."""
        share = UPPER if self.upper else LOWER
        x, y = from_field(world.pose, 0.5 * world.field.width, share * world.field.length)
        if passed > Search.ROAM_TIME or math.hypot(x, y) < Search.ROAM_NEAR:
            self.start_s, self.back_off, self.upper = world.time_s, 0.0, not self.upper
        aside = heading(x, y)
        turn = clamp(TURN_GAIN * aside, -Search.TURN_SPEED, Search.TURN_SPEED)
        forward = Search.ROAM_SPEED if abs(aside) < WALK_WITHIN else 0.0
        return kelpie.WalkRequest(forward=forward, turn_deg=turn)
