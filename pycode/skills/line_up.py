# SPDX-License-Identifier: Apache-2.0
# Circles the ball at a fixed distance, facing it, until goal, ball and robot are in one line.
import kelpie
from lib.geom import clamp, heading, wrap
from lib.tune import LineUp


def aim_error(ball, goal):
    """Degrees from the direction of the ball to that from the ball to the goal."""
    return wrap(heading(goal[0] - ball[0], goal[1] - ball[1]) - heading(*ball))


class CircleBall:
    def __init__(self, world):
        self.start_s = world.time_s
        self.side = 1.0

    def timed_out(self, world):
        return world.time_s - self.start_s > LineUp.TIME

    def tick(self, world, goal):
        """goal: in the robot frame; None circles on until it comes into view."""
        ball = (world.ball.relative.x, world.ball.relative.y)
        error = self.side * 90.0 if goal is None else aim_error(ball, goal)
        if abs(error) > 150.0:  # straight behind us: both ways are as long, so do not change
            error = self.side * 150.0
        self.side = 1.0 if error >= 0.0 else -1.0
        # To have the goal more to the right of the ball, step to the left.
        left = -clamp(LineUp.SIDE_GAIN * error, -LineUp.SIDE_SPEED, LineUp.SIDE_SPEED)
        away = world.ball.distance - LineUp.RADIUS
        forward = clamp(LineUp.FORWARD_GAIN * away, -LineUp.FORWARD_SPEED, LineUp.FORWARD_SPEED)
        # Stepping aside moves the ball the other way; the feed-forward keeps facing it.
        follow = -57.3 * left / max(world.ball.distance, 12.0)
        turn = clamp(LineUp.TURN_GAIN * heading(*ball) + follow, -LineUp.TURN_SPEED,
                     LineUp.TURN_SPEED)
        if abs(heading(*ball)) > 40.0:
            left = forward = 0.0
        return kelpie.WalkRequest(forward=forward, left=left, turn_deg=turn)
