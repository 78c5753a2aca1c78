# SPDX-License-Identifier: Apache-2.0
# The last steps: small ones, ball straight ahead, body towards the goal, until the kick can hit it.
import kelpie
from lib.geom import clamp, heading
from lib.tune import Strike


class StepToKick:
    def __init__(self, world):
        self.start_s = world.time_s

    def timed_out(self, world):
        return world.time_s - self.start_s > Strike.TIME

    def aim(self, world, goal):
        """Degrees to turn until the body points along the line from the ball to the goal."""
        if goal is None:
            return 0.0
        ball = world.ball.relative
        return heading(goal[0] - ball.x, goal[1] - ball.y)

    def lost(self, world, goal):
        ball = world.ball
        return (ball.seconds_since_seen > Strike.UNSEEN or ball.relative.y < 0.0 or
                ball.distance > Strike.GONE or
                abs(ball.relative.x) > Strike.LOST_SIDE or
                abs(self.aim(world, goal)) > Strike.LOST_AIM)

    def can_kick(self, world, goal):
        ball = world.ball.relative
        return (abs(ball.x) <= Strike.KICK_SIDE and ball.y <= Strike.KICK_FAR and
                abs(self.aim(world, goal)) <= Strike.KICK_AIM)

    def tick(self, world, goal):
        ball = world.ball.relative
        centred = abs(ball.x) <= Strike.SIDE_FIRST
        target = Strike.KICK_NEAR if centred else Strike.STAND_OFF
        ahead = ball.y - target
        forward = clamp(Strike.FORWARD_GAIN * ahead, -Strike.FORWARD_SPEED, Strike.FORWARD_SPEED)
        if centred and 0.0 < forward < Strike.LEAST_SPEED:
            forward = Strike.LEAST_SPEED
        left = clamp(-Strike.SIDE_GAIN * ball.x, -Strike.SIDE_SPEED, Strike.SIDE_SPEED)
        turn = clamp(Strike.TURN_GAIN * self.aim(world, goal), -Strike.TURN_SPEED,
                     Strike.TURN_SPEED)
        return kelpie.WalkRequest(forward=forward, left=left, turn_deg=turn)
