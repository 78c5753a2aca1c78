# SPDX-License-Identifier: Apache-2.0
# The head: follows the ball, glances at the goal while the ball is far, scans when it is lost.
# WatchBall keeps when the next glance ends and to which side; the two ways to scan keep nothing.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import heading
from lib.head import look_at, view

from situation.goal import OpponentGoal


class Watch:
    FRESH = 0.4              # an estimate that old is still looked at
    SCAN_PAN = 75.0  # deg
    SCAN_PERIOD = 2.4        # one sweep there and back
    SCAN_LOW = -32.0         # pitch of the view, sweeps alternate between the two
    SCAN_HIGH = -12.0  # deg
    GLANCE_EVERY = 2.5  # s
    GLANCE_TIME = 0.7  # s
    # Only while the ball is farther than this: around it, too. Blind until the kick, 6 s, the
    # robot lost its heading: 1.31 deg on the mean of 16 matches, 1.20 with these glances.
    GLANCE_FAR = 16.0
    GLANCE_PITCH = -6.0  # deg
    GLANCE_PAN = 60.0        # to the side, when nobody knows where the goal is
    BALL_HEIGHT = 5.0  # cm

MAX_PAN = 80.0    # deg; a goal farther to a side is not glanced at
SWEEP_PAN = 85.0  # deg


class WatchBall(Skill):
    NAME = 'watch_ball'

    def __init__(self):
        self.next_glance_s = 0.0  # when the glance that is planned ends
        self.side = 1.0           # of the last glance, left positive; 0 after frames without one

    def step(self, world, goal: OpponentGoal) -> kelpie.HeadRequest:
        ball = world.ball
        if self.glancing(world):
            return self.glance(world, goal)
        return look_at(ball.relative.x, ball.relative.y, Watch.BALL_HEIGHT, world.stance)

    def glancing(self, world) -> bool:
        """Whether the head is off the ball now: for the last GLANCE_TIME of every GLANCE_EVERY
        seconds, if the ball was far and in view when they began."""
        now = world.time_s
        if now < self.next_glance_s:
            return now > self.next_glance_s - Watch.GLANCE_TIME and self.side != 0.0
        self.next_glance_s = now + Watch.GLANCE_EVERY
        far = world.ball.distance > Watch.GLANCE_FAR
        calm = world.ball.seconds_since_seen < Watch.FRESH
        if far and calm:
            self.side = -1.0 if self.side > 0.0 else 1.0
        else:
            self.side = 0.0
        return False

    def glance(self, world, goal) -> kelpie.HeadRequest:
        goal_point = goal.where(world)
        pan = heading(*goal_point) if goal_point is not None else Watch.GLANCE_PAN * self.side
        if abs(pan) > MAX_PAN:
            pan = Watch.GLANCE_PAN * self.side
        return view(pan, -Watch.GLANCE_PITCH, world.stance)


class Scan(Skill):
    """Sweeps the whole range, low and high in turn; `passed`: seconds since it began."""

    def step(self, world, passed) -> kelpie.HeadRequest:
        phase = passed / Watch.SCAN_PERIOD
        pan = Watch.SCAN_PAN * math.sin(2.0 * math.pi * phase)
        pitch = Watch.SCAN_LOW if int(phase) % 2 == 0 else Watch.SCAN_HIGH
        return view(pan, -pitch, world.stance)


class Sweep(Skill):
    """Level and wide, for a goal and the beacons; `passed`: seconds since it began."""

    def step(self, world, passed) -> kelpie.HeadRequest:
        pan = SWEEP_PAN * math.sin(2.0 * math.pi * passed / Watch.SCAN_PERIOD)
        return view(pan, -Watch.GLANCE_PITCH, world.stance)
