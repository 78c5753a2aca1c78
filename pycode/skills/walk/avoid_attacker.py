# SPDX-License-Identifier: Apache-2.0
# Keeps off the attacker's ways (thesis 2006 section 4.3.3): plan A, the line from ball to goal,
# when it has the ball; plan B, its way to the ball, when it has not yet. Which lanes those are is
# situation/keep_off.py's; a lane that the robot stands in is left by the shorter way, walking in
# any direction with the ball in view. Keeps the lane's kind and gap. Moves as fast as it can, 35
# cm/s: an attacker that comes with 40 from behind is not outrun.
import kelpie
from arbiter.skill import Skill
from lib import paths
from lib.geom import from_field
from lib.steer import facing

STAYS = 6.0    # cm beyond the clearance until it is over
SPEED = 34.0  # cm/s
WHY = {'holds': 'get_out_of_way', 'has_ball': 'plan_a', 'on_way': 'plan_b'}


class AvoidAttacker(Skill):
    NAME = 'avoid_attacker'

    def __init__(self):
        self.kind, self.gap = 'on_way', 0.0

    @staticmethod
    def lane(world, lanes, kind, avoids):
        """The first of that kind that the robot stands in; `avoids`: it does so already."""
        here = paths.point_of(world.pose)
        for lane in lanes:
            if lane.kind == kind and lane.gap(here) < lane.clearance + (STAYS if avoids else 0.0):
                return lane
        return None

    def step(self, world, asked) -> kelpie.WalkRequest:
        """`asked`: the lane to leave, and where the ball is on the field, or None."""
        lane, ball = asked
        here = paths.point_of(world.pose)
        self.kind, self.gap = lane.kind, lane.gap(here)
        place = lane.way_off(world.field, here)
        return facing(from_field(world.pose, *place), paths.bearing_of(world, ball), speed=SPEED)

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, WHY[self.kind], '{} cm off its way',
                      self.gap))
