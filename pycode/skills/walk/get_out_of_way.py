# SPDX-License-Identifier: Apache-2.0
# Makes room for a mate that holds the ball: it turns and may shoot anywhere near the goal's
# direction. 60 cm off the first 250 cm of its line to the goal and 60 cm from itself (facts-2005
# section 7.2), and some frames longer than that is demanded, as a shot follows. Keeps those frames.
import kelpie
from skills.walk.avoid_attacker import AvoidAttacker

FRAMES = {kelpie.DEFENDER: 75, kelpie.STRIKER: 45, kelpie.SUPPORTER: 45}  # frames


class GetOutOfWay(AvoidAttacker):
    NAME = 'get_out_of_way'

    def __init__(self, role=kelpie.STRIKER):
        super().__init__()
        self.maximum = FRAMES.get(role, 45)
        self.left = 0         # frames for which the last lane is still kept
        self.kept = None

    def update(self, lanes) -> None:
        """Once a frame."""
        holders = [lane for lane in lanes if lane.kind == 'holds']
        if holders:
            self.kept, self.left = holders, self.maximum
        elif self.left > 0:
            self.left -= 1

    def lane_to_leave(self, world, avoids):
        """The lane of a mate that holds the ball, or has just held it, if the robot is in it."""
        return self.lane(world, self.kept, 'holds', avoids) if self.left > 0 else None
