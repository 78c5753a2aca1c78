# SPDX-License-Identifier: Apache-2.0
# Whether the ball is not where gps believes it: images have shown the place for some frames and no
# ball. Keeps how many, and that it was so until the ball is seen again. Says nothing of a place
# under the chin, far away, or behind a robot that vision sees.
from lib.lost_ball import MISSED_FRAMES
from lib.projection import off_axis

NEAREST, FARTHEST = 25.0, 220.0  # cm between which vision sees nearly every ball
SHOWN = 17.0          # deg from the camera's axis; the image's half is 22 deg high
BALL_RADIUS = 4.2     # cm
HIDDEN_WITHIN = 15.0  # deg from a nearer robot


class Doubt:
    def __init__(self):
        self.missed = 0
        self.refuted = False

    def update(self, world) -> None:
        if world.percepts.ball.present:
            self.missed, self.refuted = 0, False
        elif shown(world):
            self.missed += 1
            self.refuted = self.refuted or self.missed >= MISSED_FRAMES


def shown(world) -> bool:
    """Whether the image has the place of the believed ball in it, with nobody before it."""
    ball = world.ball
    if not ball.present or not NEAREST < ball.distance < FARTHEST:
        return False
    if any(abs(robot.heading_deg - ball.heading_deg) < HIDDEN_WITHIN
           and robot.distance < ball.distance for robot in world.percepts.robots):
        return False
    return off_axis(world, (ball.relative.x, ball.relative.y, BALL_RADIUS)) < SHOWN
