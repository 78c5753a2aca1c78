# SPDX-License-Identifier: Apache-2.0
# The last steps: small ones, ball straight ahead, body towards the goal, until the kick can hit it.
# Keeps nothing; the ball is where gps believes it, since the chin hides it below 6 cm.
import kelpie
from arbiter.skill import Skill
from lib.geom import Point, clamp, heading


class Strike:
    # The ball's place in the robot frame from which the kick hits it.
    KICK_AHEAD = 14.0        # actuator/data/motions/kick_forward.toml
    KICK_NEAR = 12.4  # cm
    KICK_FAR = 15.4          # 190 ms pass until the kick begins: 1.5 cm at MIN_SPEED
    KICK_SIDE = 1.8  # cm
    KICK_AIM = 14.0          # deg between the robot's and the goal's direction
    FORWARD_GAIN = 1.5  # cm/s per cm
    FORWARD_SPEED = 26.0  # cm/s
    GONE = 45.0              # the ball has rolled away: walk to it again
    MIN_SPEED = 8.0  # cm/s
    SIDE_GAIN = 1.5  # cm/s per cm
    SIDE_SPEED = 7.0  # cm/s
    SIDE_FIRST = 3.0         # the ball farther to the side: do not go closer than STAND_OFF
    STAND_OFF = 18.0  # cm
    TURN_GAIN = 1.2  # deg/s per deg
    TURN_SPEED = 30.0  # deg/s
    LOST_AIM = 28.0          # line up again
    LOST_SIDE = 9.0  # cm
    UNSEEN = 1.5             # the chin hides a near ball; odometry carries it that long
    TIME = 8.0  # s


class StepToKick(Skill):
    NAME = 'strike'

    def aim(self, world, goal_point: Point | None) -> float:
        """Degrees to turn until the body points along the line from the ball to the goal."""
        if goal_point is None:
            return 0.0
        ball = world.ball.relative
        return heading(goal_point[0] - ball.x, goal_point[1] - ball.y)

    def out_of_reach(self, world, goal_point) -> bool:
        """Whether small steps no longer help: the ball or the line to the goal has to be found or
        lined up again."""
        ball = world.ball
        return (ball.seconds_since_seen > Strike.UNSEEN or ball.relative.y < 0.0 or
                ball.distance > Strike.GONE or
                abs(ball.relative.x) > Strike.LOST_SIDE or
                abs(self.aim(world, goal_point)) > Strike.LOST_AIM)

    def can_kick(self, world, goal_point) -> bool:
        ball = world.ball.relative
        return (abs(ball.x) <= Strike.KICK_SIDE and
                Strike.KICK_NEAR <= ball.y <= Strike.KICK_FAR and
                abs(self.aim(world, goal_point)) <= Strike.KICK_AIM)

    def step(self, world, goal_point) -> kelpie.WalkRequest:
        ball = world.ball.relative
        centred = abs(ball.x) <= Strike.SIDE_FIRST
        target = Strike.KICK_AHEAD if centred else Strike.STAND_OFF
        ahead = ball.y - target
        forward = clamp(Strike.FORWARD_GAIN * ahead, -Strike.FORWARD_SPEED, Strike.FORWARD_SPEED)
        if centred and 0.0 < forward < Strike.MIN_SPEED:
            forward = Strike.MIN_SPEED
        if ball.y < Strike.KICK_NEAR:
            forward = -Strike.MIN_SPEED
        left = clamp(-Strike.SIDE_GAIN * ball.x, -Strike.SIDE_SPEED, Strike.SIDE_SPEED)
        turn = clamp(Strike.TURN_GAIN * self.aim(world, goal_point), -Strike.TURN_SPEED,
                     Strike.TURN_SPEED)
        return kelpie.WalkRequest(forward=forward, left=left, turn_deg=turn)
