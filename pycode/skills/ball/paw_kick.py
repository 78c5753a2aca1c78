# SPDX-License-Identifier: Apache-2.0
# The clearance of 2004 (thesis 2004 section 4.2.2): the goalie runs so that a front leg meets the
# ball's middle, and the leg's next step forward strikes it. Keeps the side of that leg. It works
# for a ball from ahead with nobody behind it; in a scrum the robot only pushes, as the thesis says.
import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, heading
from lib.tune_goalie import Paw
from skills.walk.guard_goal import in_box


class PawKick(Skill):
    NAME = 'paw_kick'

    def __init__(self):
        self.side = 0.0   # of the leg: +1 right, 0 none yet

    def can(self, world) -> bool:
        """Always: it only runs. Whether the ball may become an own goal it does not ask."""
        return True

    def step(self, world) -> kelpie.WalkRequest:
        ball = world.ball.relative
        if self.side == 0.0:
            self.side = 1.0 if ball.x >= 0.0 else -1.0
        aside = heading(ball.x - self.side * Paw.SIDE, max(ball.y, 1.0))
        turn = clamp(Paw.TURN_GAIN * aside, -Paw.TURN, Paw.TURN)
        return in_box(world, kelpie.WalkRequest(forward=Paw.SPEED, turn_deg=turn))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, 'right' if self.side > 0.0 else 'left',
                      'a front leg is to meet the ball'))
