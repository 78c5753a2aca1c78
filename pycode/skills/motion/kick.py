# SPDX-License-Identifier: Apache-2.0
# Asks for a kick until it runs, then waits for its end. Keeps which, when it began and whether the
# motion has run, from world.motion. A kick that never starts is given up after START_TIME of
# lib/tune.py; whether the ball was hit it cannot tell.
import kelpie
from arbiter.skill import Skill
from lib import tune


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
        self.done = (not running or passed > tune.Kick.TIME) if self.ran else (
            passed > tune.Kick.START_TIME)
        return kelpie.NO_MOTION if self.ran else self.which
