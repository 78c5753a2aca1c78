# SPDX-License-Identifier: Apache-2.0
# A condition over time: a gap that is short does not end it. Keeps when it began and when it held
# last, from what it is told in each frame. Told late, it takes the frames between for a gap.
import math


class Lasting:
    def __init__(self, gap_s):
        self.gap_s = gap_s
        self.end()

    def end(self) -> None:
        """The next time that it holds is a new beginning."""
        self.from_s = self.last_s = -math.inf

    def update(self, time_s, holds) -> None:
        if not holds:
            return
        if time_s - self.last_s > self.gap_s:
            self.from_s = time_s
        self.last_s = time_s

    def for_less_than(self, time_s, longest_s) -> bool:
        """Whether it holds, and began less than so many seconds ago."""
        return time_s - self.last_s < self.gap_s and time_s - self.from_s < longest_s
