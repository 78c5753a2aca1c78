# SPDX-License-Identifier: Apache-2.0
# The head: follows the ball, glances at the goal while the ball is far, scans when it is lost.
import math

from lib.geom import heading
from lib.head import look_at, view
from lib.tune import Search, Watch


class WatchBall:
    def __init__(self):
        self.next_glance_s = 0.0
        self.side = 1.0

    def tick(self, world, goal):
        """goal: OpponentGoal."""
        ball = world.ball
        if self.glancing(world):
            return self.glance(world, goal)
        return look_at(ball.relative.x, ball.relative.y, Watch.BALL_HEIGHT, world.stance)

    def glancing(self, world):
        now = world.time_s
        if now < self.next_glance_s:
            return now > self.next_glance_s - Watch.GLANCE_TIME and self.side != 0.0
        far = world.ball.distance > Watch.GLANCE_FAR
        calm = world.ball.seconds_since_seen < Watch.FRESH
        if not far or not calm:
            self.next_glance_s = now + Watch.GLANCE_EVERY
            self.side = 0.0
            return False
        self.side = -1.0 if self.side > 0.0 else 1.0
        self.next_glance_s = now + Watch.GLANCE_EVERY
        return False

    def glance(self, world, goal):
        point = goal.where(world)
        pan = heading(*point) if point is not None else Watch.GLANCE_PAN * self.side
        if abs(pan) > 80.0:
            pan = Watch.GLANCE_PAN * self.side
        return view(pan, -Watch.GLANCE_PITCH, world.stance)


class Scan:
    """Sweeps the whole range, low and high in turn."""

    def tick(self, world, since_s):
        phase = since_s / Watch.SCAN_PERIOD
        pan = Watch.SCAN_PAN * math.sin(2.0 * math.pi * phase)
        pitch = Watch.SCAN_LOW if int(phase) % 2 == 0 else Watch.SCAN_HIGH
        return view(pan, -pitch, world.stance)


class Spin:
    """Ahead of the turn of the body, nodding between near and far."""

    def tick(self, world, side):
        phase = world.time_s / (0.5 * Watch.SCAN_PERIOD)
        pitch = Watch.SCAN_LOW if math.sin(2.0 * math.pi * phase) < 0.0 else Watch.SCAN_HIGH
        return view(side * Watch.SPIN_PAN, -pitch, world.stance)


class Sweep:
    """Level and wide, for a goal and the beacons."""

    def tick(self, world, since_s):
        pan = 85.0 * math.sin(2.0 * math.pi * since_s / Watch.SCAN_PERIOD)
        return view(pan, -Watch.GLANCE_PITCH, world.stance)


def search_side(world):
    """The side on which the ball was last believed to be: +1 left."""
    return 1.0 if world.ball.heading_deg >= 0.0 else -1.0


def lost_at_feet(world):
    return world.ball.present and world.ball.distance < Search.BACK_OFF_NEAR
