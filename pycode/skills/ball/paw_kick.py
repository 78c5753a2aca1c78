# SPDX-License-Identifier: Apache-2.0
# The clearance of 2004 (thesis 2004 section 4.2.2): the goalie runs so that a front leg meets the
# ball's middle, and the leg's next step forward strikes it. Keeps the side of that leg. It works
# for a ball from ahead with nobody behind it; in a scrum the robot only pushes, as the thesis says.
import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, heading

from safety import own_box


class Paw:
    SIDE = 5.0               # cm from the middle to a front leg
    SPEED = 34.0  # cm/s
    TURN_GAIN = 3.0  # deg/s per deg
    TURN = 120.0  # deg/s
    VISUAL = 15.0            # cm; a seen ball that near starts the attack
    MAX_OFF = 40.0           # deg; one seen farther off ends it


class PawKick(Skill):
    NAME = 'paw_kick'

    def __init__(self):
        self.side = 0.0   # of the leg: +1 right, 0 none yet

    def step(self, world, stand=None) -> kelpie.WalkRequest:
        """It only runs: whether the ball may become an own goal it does not ask."""
        ball = world.ball.relative
        if self.side == 0.0:
            self.side = 1.0 if ball.x >= 0.0 else -1.0
        off_deg = heading(ball.x - self.side * Paw.SIDE, max(ball.y, 1.0))
        turn = clamp(Paw.TURN_GAIN * off_deg, -Paw.TURN, Paw.TURN)
        return own_box.inside(world, kelpie.WalkRequest(forward=Paw.SPEED, turn_deg=turn))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, 'right' if self.side > 0.0 else 'left',
                      'a front leg is to meet the ball'))
