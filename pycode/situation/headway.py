# SPDX-License-Identifier: Apache-2.0
# Whether a robot that walks ahead comes nearer to the ball in its view. Two robots whose legs have
# caught each other push side by side and no paw feels it: an attacker and a goalie did so for 15 s,
# 30 cm from the ball. Keeps the nearest distance and the frames walked ahead since it was reached.
# Takes the distance alone: who is held believes, by its odometry, that the ball rolls. A ball that
# it follows as fast as it rolls away looks the same; the price is one step back.
import math

SEEN_S = 0.5          # s
NEAR = 18.0           # cm; nearer, the robot may be meant to stop
AWAY = 15.0           # cm; a ball that much farther off rolls away, and all begins anew
WALKS_AHEAD = 8.0     # cm/s that are asked for
NEARER = 4.0          # cm; the distance is wrong by 2 % (docs/physical-body.md)
MAX_FRAMES = 45       # a walk that is free goes 50 cm in them


class Headway:
    def __init__(self):
        self.nearest = math.inf
        self.frames = 0

    def update(self, world) -> None:
        """To be called once in every frame."""
        ball = world.ball
        if (not ball.present or ball.seconds_since_seen > SEEN_S or ball.distance < NEAR or
                not -AWAY < self.nearest - ball.distance < NEARER):
            self.begin_at(ball.distance if ball.present else math.inf)
        elif world.last_command.walk.forward > WALKS_AHEAD:
            self.frames += 1

    def begin_at(self, distance) -> None:
        self.nearest, self.frames = distance, 0

    @property
    def none(self) -> bool:
        """Whether the ball has not come nearer for too long."""
        return self.frames > MAX_FRAMES
