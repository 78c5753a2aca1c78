# SPDX-License-Identifier: Apache-2.0
# A condition over time: a gap that is short does not end it, and it counts for so long only. Keeps
# when it began and when it held last, from what it is given in each frame. Called late, it takes
# the frames between for a gap.
import math


class Lasting:
    def __init__(self, gap_s, longest_s):
        self.gap_s, self.longest_s = gap_s, longest_s
        self.end()

    def end(self) -> None:
        """The next time that it holds is a new beginning."""
        self.from_s = self.last_s = -math.inf

    def update(self, time_s, holds) -> bool:
        """Whether it holds, or did within the gap, and does not do so for too long."""
        if holds:
            if time_s - self.last_s > self.gap_s:
                self.from_s = time_s
            self.last_s = time_s
        return time_s - self.last_s < self.gap_s and time_s - self.from_s < self.longest_s
