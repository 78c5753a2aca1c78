# SPDX-License-Identifier: Apache-2.0
# Asks for the motion that brings a fallen robot to its feet, by the side that the body feels. Keeps
# whether it asked in the last frame: between two motions one frame must ask for none.
import kelpie
from arbiter.skill import Skill

MOTIONS = {kelpie.ON_FRONT: kelpie.GET_UP_FRONT, kelpie.ON_BACK: kelpie.GET_UP_BACK,
           kelpie.ON_LEFT: kelpie.GET_UP_LEFT, kelpie.ON_RIGHT: kelpie.GET_UP_RIGHT}


class GetUp(Skill):
    NAME = 'get_up'

    def __init__(self):
        self.asked = False

    @staticmethod
    def needed(world) -> bool:
        return (world.motion.feeling.fallen in MOTIONS or
                world.motion.running in MOTIONS.values())

    def step(self, world) -> int:
        """The motion to ask for, or NO_MOTION."""
        motion = MOTIONS.get(world.motion.feeling.fallen, kelpie.NO_MOTION)
        if self.asked or world.motion.running != kelpie.NO_MOTION:
            motion = kelpie.NO_MOTION
        self.asked = motion != kelpie.NO_MOTION
        return motion
