# SPDX-License-Identifier: Apache-2.0
# Circles the ball at a fixed distance, facing it, until goal, ball and robot are in one line. Keeps
# the side it goes to, so that a goal straight behind does not make it turn back and forth.
import kelpie
from arbiter.skill import Skill
from lib.geom import Point, clamp, heading, wrap


class LineUp:
    RADIUS = 20.0            # distance kept while circling the ball
    SIDE_SPEED = 15.0  # cm/s
    SIDE_GAIN = 0.4          # cm/s per deg
    FORWARD_GAIN = 1.2       # cm/s per cm
    FORWARD_SPEED = 10.0  # cm/s
    TURN_GAIN = 2.0  # deg/s per deg
    TURN_SPEED = 70.0  # deg/s
    AIMED = 10.0             # deg between ball and goal direction
    FACED = 15.0             # deg between body and ball
    LEFT_BEHIND = 38.0       # a ball farther than this has to be walked to again
    TIME = 15.0  # s

MAX_ERROR = 150.0     # deg; beyond it the goal is behind, and both ways are as long
MIN_DISTANCE = 12.0   # cm; with a nearer ball the feed-forward would be a spin
STEP_WITHIN = 40.0    # deg; a ball farther to a side is faced first
DEGREES = 57.3        # per radian


def aim_error(ball, goal_point) -> float:
    """Degrees from the direction of the ball to that from the ball to the goal, left positive."""
    return wrap(heading(goal_point[0] - ball[0], goal_point[1] - ball[1]) - heading(*ball))


class CircleBall(Skill):
    NAME = 'line_up'

    def __init__(self):
        self.side = 1.0  # the sign of the last aim error

    def step(self, world, goal_point: Point | None) -> kelpie.WalkRequest:
        """Without a goal it circles on until one comes into view."""
        ball = (world.ball.relative.x, world.ball.relative.y)
        error = self.aim(ball, goal_point)
        # To have the goal more to the right of the ball, step to the left.
        left = -clamp(LineUp.SIDE_GAIN * error, -LineUp.SIDE_SPEED, LineUp.SIDE_SPEED)
        away = world.ball.distance - LineUp.RADIUS
        forward = clamp(LineUp.FORWARD_GAIN * away, -LineUp.FORWARD_SPEED, LineUp.FORWARD_SPEED)
        # A step to one side moves the ball to the other; the feed-forward keeps facing it.
        follow = -DEGREES * left / max(world.ball.distance, MIN_DISTANCE)
        turn = clamp(LineUp.TURN_GAIN * heading(*ball) + follow, -LineUp.TURN_SPEED,
                     LineUp.TURN_SPEED)
        if abs(heading(*ball)) > STEP_WITHIN:
            left = forward = 0.0
        return kelpie.WalkRequest(forward=forward, left=left, turn_deg=turn)

    def aim(self, ball, goal_point):
        """aim_error(), but straight behind on the side of the last one; 90 deg without a goal."""
        error = self.side * 90.0 if goal_point is None else aim_error(ball, goal_point)
        if abs(error) > MAX_ERROR:
            error = self.side * MAX_ERROR
        self.side = 1.0 if error >= 0.0 else -1.0
        return error
