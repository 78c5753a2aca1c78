# SPDX-License-Identifier: Apache-2.0
# Lets a held ball lie: asks for the motion that stands until the ball rests and then raises the
# head, and waits for its end. Keeps when it began and whether the motion ran.
import kelpie
from arbiter.skill import Skill

START_S = 0.6  # s
LONGEST_S = 2.0  # s


class Release(Skill):
    NAME = 'release'

    def __init__(self, world):
        self.start_s = world.time_s
        self.ran = False

    def step(self, world) -> int:
        """The motion to ask for, or NO_MOTION once it runs."""
        running = world.motion.running == kelpie.RELEASE
        self.ran = self.ran or running
        passed = world.time_s - self.start_s
        self.done = (not running or passed > LONGEST_S) if self.ran else passed > START_S
        return kelpie.NO_MOTION if self.ran else kelpie.RELEASE
