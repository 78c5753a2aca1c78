# SPDX-License-Identifier: Apache-2.0
# Asks for a kick until it runs, then waits for its end. Keeps which, when it began and whether the
# motion has run, from world.motion. A kick that never starts is given up after START_TIME; whether
# the ball was hit it cannot tell.
import kelpie
from arbiter.skill import Skill

START_TIME = 1.5   # s for the motion to begin
TIME = 5.0         # s


class Kick(Skill):
    NAME = 'kick'

    def __init__(self, world, which=kelpie.KICK_FORWARD):
        self.which = which
        self.start_s = world.time_s
        self.ran = False

    def step(self, world) -> int:
        """The motion to ask for: the kick's, or NO_MOTION once it runs."""
        running = world.motion.running == self.which
        self.ran = self.ran or running
        passed = world.time_s - self.start_s
        self.done = (not running or passed > TIME) if self.ran else (
            passed > START_TIME)
        return kelpie.NO_MOTION if self.ran else self.which
