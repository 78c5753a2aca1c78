# SPDX-License-Identifier: Apache-2.0
# What the legs of a goalie do for a ball that it has lost close by. One at the feet is under the
# chin: a step back shows it. One beside the body is seen only when that turns. After a motion
# nobody knows where it lies: after a kick that missed, who walks takes it into the own goal, or who
# turns fast; and with an opponent at hand who does either. Keeps nothing.
import kelpie
from arbiter.skill import Skill
from safety import own_box
from safety.own_goal import up_field
from situation import opponents
from situation.ball_at_body import under_chin

BACK_OFF = -15.0     # cm/s from a ball under the chin
TURN = 110.0         # deg/s to the side where a near ball was lost,
MAX_TURNED = 105.0   # deg from up-field (who faces wrong is turned back), and slower
KICKED_TURN = 70.0   # deg/s after a kick: a ball at the flank then rolls 20 cm and no farther


class LookAbout(Skill):
    NAME = 'look_about'

    def __init__(self, now):
        self.now = now

    def step(self, world, side) -> kelpie.WalkRequest:
        """`side`: to which the head asks the body to turn, +1 left; 0: to none."""
        if opponents.at_hand(world):
            return kelpie.WalkRequest()
        moved = not self.now.seen_since_motion
        if side != 0.0:
            rate = KICKED_TURN if moved and self.now.kicked else TURN
            return kelpie.WalkRequest(turn_deg=up_field(self.now, side * rate, MAX_TURNED))
        if moved:
            return kelpie.WalkRequest()
        back = BACK_OFF if under_chin(world) else 0.0
        return own_box.inside(world, kelpie.WalkRequest(forward=back))
