# SPDX-License-Identifier: Apache-2.0
# What all looks at landmarks have in common while somebody plays: for some frames the head is off
# the ball, and the memory knows since when the last one was. Keeps the landmark and the frames of
# this look.
from arbiter.machine import Machine


class LandmarkLook(Machine):
    def __init__(self, memory, state):
        super().__init__(state)
        self.memory = memory
        self.mark = None    # the landmark of this look
        self.frames = 0     # of it so far

    def look_on(self) -> None:
        """One more frame off the ball."""
        self.frames += 1
        self.memory.looked_for_landmarks()
