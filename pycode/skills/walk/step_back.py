# SPDX-License-Identifier: Apache-2.0
# A step back from a ball between the paws, which a referee counts as held whether it is gripped or
# not (3 s, docs/physical-body.md): it comes into view and lies free. Keeps when it began. Whether
# the ball was there it cannot tell.
import kelpie
from arbiter.skill import Skill

SECONDS = 0.4   # s,
SPEED = -50.0   # cm/s: a dozen cm, of which the ball needs eight


class StepBack(Skill):
    NAME = 'step_back'

    def __init__(self, world):
        self.start_s = world.time_s

    def step(self, world) -> kelpie.WalkRequest:
        self.done = world.time_s - self.start_s > SECONDS
        return kelpie.WalkRequest(forward=SPEED, kind=kelpie.WALK_BACK)
