# SPDX-License-Identifier: Apache-2.0
# Asks for the forward kick until it runs, then waits for its end. Keeps when it began and whether
# the motion has run, from world.motion. A kick that never starts is given up after
# Kick.START_TIME; whether the ball was hit it cannot tell.
import kelpie
from lib.tune import Kick


class KickForward:
    def __init__(self, world):
        self.start_s = world.time_s
        self.ran = False

    def done(self, world) -> bool:
        passed = world.time_s - self.start_s
        if self.ran:
            return world.motion.running != kelpie.KICK_FORWARD or passed > Kick.TIME
        return passed > Kick.START_TIME

    def motion(self, world) -> int:
        """The motion to ask for: KICK_FORWARD or NO_MOTION."""
        if world.motion.running == kelpie.KICK_FORWARD:
            self.ran = True
        return kelpie.NO_MOTION if self.ran else kelpie.KICK_FORWARD
