# SPDX-License-Identifier: Apache-2.0
# Keeps where the opponent goal is in the robot frame: as last seen, carried along by odometry for
# Goal.FRESH seconds, else from the pose if that is good, None when neither is; and when a skill
# looked for it. Fails after a slip
# that odometry does not report: a carried goal is then wrong until it is seen again.
import kelpie
from lib.geom import Point, from_field, moved, polar


class Goal:
    FRESH = 6.0              # seconds for which a seen goal is carried along by odometry
    POSE_HEADING_SD = 20.0   # poses worse than this say nothing about the goal
    POSE_FRESH = 15.0        # neither do those without a landmark for so long
    SWEEP = 2.6              # look for it that long before playing without
    REGAIN = 1.0             # then look for the ball again that long

NEVER_S = -1e9  # s
BALL_RADIUS = 4.2    # cm
UP_FIELD_DEG = 90.0  # the direction of the opponents' goal on the field
MIN_DISTANCE = 30.0  # cm; a percept of a nearer goal would put it inside the robot


class OpponentGoal:
    def __init__(self):
        self.point = None       # as last seen, moved on since
        self.seen_s = NEVER_S
        self.looked_s = NEVER_S  # when a skill last stood still to look for it

    def update(self, world):
        """Takes one frame's odometry and percepts; to be called in every frame."""
        if self.seen(world):
            self.point = moved(*self.point, world.odometry)
        target = kelpie.GOAL_BLUE if world.game.team == kelpie.RED else kelpie.GOAL_YELLOW
        for mark in world.percepts.landmarks:
            # The visible part of a cut goal is still goal: good enough to shoot at.
            if mark.kind == target:
                self.point = polar(max(mark.distance, MIN_DISTANCE), mark.heading_deg)
                self.seen_s = world.time_s

    def looked(self, world) -> None:
        """A skill stood still to look for it."""
        self.looked_s = world.time_s

    def seen(self, world) -> bool:
        return self.point is not None and world.time_s - self.seen_s < Goal.FRESH

    def where(self, world) -> Point | None:
        """The point to shoot at: the middle of the mouth, or of the back wall for a ball that lies
        before the mouth. From one on the line the way to the mouth's middle is along the line, and
        whoever lines up for it stands against a post."""
        mouth = self.mouth(world)
        if mouth is None or not before_mouth(world):
            return mouth
        x, y = polar(world.field.goal_depth, UP_FIELD_DEG - world.pose.heading_deg)
        return mouth[0] + x, mouth[1] + y

    def mouth(self, world) -> Point | None:
        if self.seen(world):
            return self.point
        field = world.field
        return from_field(world.pose, 0.5 * field.width, field.length) if sure(world) else None


def sure(world) -> bool:
    """Whether the pose is good enough to tell where the goal is."""
    return (world.heading_sd_deg < Goal.POSE_HEADING_SD and
            world.seconds_since_landmark < Goal.POSE_FRESH)


def before_mouth(world) -> bool:
    """Whether a ball going straight up-field would go into the goal."""
    lateral = abs(world.ball.position.x - 0.5 * world.field.width)
    return sure(world) and lateral < 0.5 * world.field.goal_width - BALL_RADIUS
