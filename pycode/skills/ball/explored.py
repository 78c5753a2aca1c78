# SPDX-License-Identifier: Apache-2.0
# Which directions around a robot its camera has shown since a search began. Keeps how far the body
# turned by odometry and a yes or no for each sector. A robot that walks away, or a ball that rolls
# into a sector after it was seen, makes it wrong: whoever has gone somewhere begins anew.
import math

from lib.geom import TURN

SECTORS = 36  # of the circle
WIDTH = TURN / SECTORS   # deg
HALF_VIEW = 22.0         # deg; half an image is 28, less a ball at its edge and a sector's half


class Explored:
    def __init__(self):
        self.turned = 0.0  # deg to the left since the beginning
        self.seen = [False] * SECTORS

    def update(self, world) -> None:
        """One frame's odometry and the sectors that it shows."""
        self.turned += world.odometry.turn_deg
        pan = self.turned + world.head.head_pan_deg
        first = math.ceil((pan - HALF_VIEW) / WIDTH)
        last = math.floor((pan + HALF_VIEW) / WIDTH)
        for sector in range(first, last + 1):
            self.seen[sector % SECTORS] = True

    @property
    def unseen(self) -> int:
        """Sectors that were not shown."""
        return SECTORS - sum(self.seen)

    def next_unseen(self, side) -> float:
        """Degrees from straight ahead, to the left (+1) or right (-1), to the first sector that
        was not shown; 0 to 360, and 360 when all were."""
        ahead = round(self.turned / WIDTH)
        for i in range(SECTORS):
            if not self.seen[(ahead + round(side) * i) % SECTORS]:
                return i * WIDTH
        return TURN
