# SPDX-License-Identifier: Apache-2.0
# Whether the ball is not at a place where somebody believes it: images have shown the place for
# some frames and no ball. Keeps how many, and that it was so until the ball is seen again. Says
# nothing of a place under the chin, far away, or behind a robot that vision sees.
import math

from lib.geom import heading
from lib.projection import off_axis
from skills.ball.lost_ball import MISSED_FRAMES

NEAREST = 16.0  # cm,
FARTHEST = 220.0  # cm between which vision sees nearly every ball
SHOWN = 17.0          # deg from the camera's axis; the image's half is 22 deg high
BALL_RADIUS = 4.2     # cm
HIDDEN_WITHIN = 15.0  # deg from a nearer robot


class Doubt:
    def __init__(self, missed=0):
        self.missed = missed  # frames that showed the place, and no ball
        self.refuted = False

    def update(self, world, place) -> None:
        """One frame's image; `place`: (x, y) in the robot frame, None while there is none."""
        if world.percepts.ball.present:
            self.missed, self.refuted = 0, False
        elif place is not None and shown(world, *place):
            self.missed += 1
            self.refuted = self.refuted or self.missed >= MISSED_FRAMES


def shown(world, x, y) -> bool:
    """Whether the image has a ball at that place in it, with nobody before it."""
    away, off_deg = math.hypot(x, y), heading(x, y)
    if not NEAREST < away < FARTHEST:
        return False
    if any(abs(robot.heading_deg - off_deg) < HIDDEN_WITHIN and robot.distance < away
           for robot in world.percepts.robots):
        return False
    return off_axis(world, (x, y, BALL_RADIUS)) < SHOWN
