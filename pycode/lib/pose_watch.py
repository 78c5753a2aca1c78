# SPDX-License-Identifier: Apache-2.0
# Whether the pose has just jumped: farther from where odometry carried it than a goalie that stands
# in its box can have slipped. Keeps the carried pose and since when the other one is doubted. Of a
# goalie's frames 1.5 % had a pose off by more than 30 cm or deg, mostly for 0.2 s, after a block or
# with somebody at its legs. A jump that lasts is believed in the end, right or wrong.
import math

from lib.geom import wrap

JUMP_CM, JUMP_DEG = 35.0, 35.0
BACK_CM, BACK_DEG = 20.0, 20.0   # so near to the carried pose it is right again
LONGEST = 0.6                    # s


class PoseWatch:
    def __init__(self):
        self.carried = None     # x, y, heading in deg
        self.since_s = None     # when the doubt began; None without one

    def update(self, world):
        """To be called in every frame."""
        if self.carried is None:
            self.carried = told(world)
        self.carried = moved(self.carried, world.odometry)
        away, aside = apart(self.carried, told(world))
        if self.since_s is None and (away > JUMP_CM or aside > JUMP_DEG):
            self.since_s = world.time_s
        right = away < BACK_CM and aside < BACK_DEG
        if self.since_s is not None and (right or world.time_s - self.since_s > LONGEST):
            self.since_s = None
        if self.since_s is None:
            self.carried = told(world)

    @property
    def doubtful(self) -> bool:
        return self.since_s is not None


def told(world) -> tuple[float, float, float]:
    return world.pose.position.x, world.pose.position.y, world.pose.heading_deg


def moved(pose, odometry) -> tuple[float, float, float]:
    """A pose after one frame's odometry, the step taken along half the turn."""
    angle = math.radians(pose[2] + 0.5 * odometry.turn_deg)
    forward, left = odometry.forward, odometry.left
    return (pose[0] + forward * math.cos(angle) - left * math.sin(angle),
            pose[1] + forward * math.sin(angle) + left * math.cos(angle),
            pose[2] + odometry.turn_deg)


def apart(a, b) -> tuple[float, float]:
    """How far two poses are from each other, cm and deg."""
    return math.hypot(a[0] - b[0], a[1] - b[1]), abs(wrap(a[2] - b[2]))
