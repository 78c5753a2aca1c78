# SPDX-License-Identifier: Apache-2.0
# Runs into the ball and drives it on without a grab (leaf Dribble of thesis 2006 section 5.4):
# fast, for when somebody else is near or the way ahead is free. Steers for a side of the ball, so
# that it goes to the goal. Keeps when it began. The ball goes where the chest sends it, within 30
# deg.
import math

import kelpie
from arbiter.machine import Machine
from lib.geom import clamp, heading, wrap
from skills.head.track_ball import TrackBall

SPEED = 40.0         # cm/s
TURN_GAIN = 2.0      # deg/s per deg
TURN_SPEED = 100.0  # deg/s
LATERAL = 4.0          # cm at most beside the ball's middle
LATERAL_GAIN = 0.1     # cm per deg that the goal is off
FACED = 50.0         # deg: turn to the ball first
LONGEST = 4.0        # s
BACK = 110.0         # deg: it is not driven on when the goal lies so far off its way,
NEAR = 40.0          # cm: which is known when it is near


class Dribble(Machine):
    NAME = 'dribble'
    committed = False

    def __init__(self, memory, where):
        """`where`: asked for the heading (deg) that the ball shall go to."""
        super().__init__(self.run)
        self.memory = memory
        self.where = where
        self.track = TrackBall(memory)

    @property
    def done(self) -> bool:
        return self.state == self.ended

    def run(self, world):
        if self.timed_out(world, LONGEST):
            return self.enter(world, self.ended, None, 'ran {} s', LONGEST)
        ball = world.ball.relative
        wanted = wrap(self.where(world) - heading(ball.x, ball.y))
        if abs(wanted) > BACK and world.ball.distance < NEAR:
            return self.enter(world, self.ended, None, 'the goal is {} deg off its way', wanted)
        # To send it left one hits its right side.
        lateral = clamp(LATERAL_GAIN * wanted, -LATERAL, LATERAL)
        bearing = heading(ball.x + lateral, ball.y)
        turn = clamp(TURN_GAIN * bearing, -TURN_SPEED, TURN_SPEED)
        forward = 0.0 if abs(bearing) > FACED else SPEED * math.cos(math.radians(bearing))
        walk = kelpie.WalkRequest(forward=forward, turn_deg=turn, kind=kelpie.WALK_FAST)
        return kelpie.Command(walk=walk, head=self.track.step(world))

    def ended(self, world):
        return kelpie.Command(head=self.track.step(world))
