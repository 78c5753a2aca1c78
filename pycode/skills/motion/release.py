# SPDX-License-Identifier: Apache-2.0
# Lets a held ball lie: asks for the motion that stands until the ball rests and then raises the
# head, and waits for its end. Keeps when it began and whether the motion ran.
import kelpie
from skills.ball.hold import carry

START_S = 0.6
LONGEST_S = 2.0


class Release:
    def __init__(self, world):
        self.start_s = world.time_s
        self.ran = False

    def done(self, world) -> bool:
        passed = world.time_s - self.start_s
        if self.ran:
            return world.motion.running != kelpie.RELEASE or passed > LONGEST_S
        return passed > START_S

    def command(self, world) -> kelpie.Command:
        if world.motion.running == kelpie.RELEASE:
            self.ran = True
        command = carry()
        command.motion = kelpie.NO_MOTION if self.ran else kelpie.RELEASE
        return command
