# SPDX-License-Identifier: Apache-2.0
# Where the opponent goal is in the robot frame: as seen, then carried by odometry for a while, else
# from the pose if that is good; None when nobody knows.
import kelpie
from lib.geom import from_field, moved, polar
from lib.tune import Field, Goal


class OpponentGoal:
    def __init__(self):
        self.point = None
        self.seen_s = -1e9

    def tick(self, world):
        if self.point is not None:
            self.point = moved(*self.point, world.odometry)
        target = kelpie.GOAL_BLUE if world.game.team == kelpie.RED else kelpie.GOAL_YELLOW
        for mark in world.percepts.landmarks:
            # The visible part of a cut goal is still goal: good enough to shoot at.
            if mark.kind == target:
                self.point = polar(max(mark.distance, 30.0), mark.heading_deg)
                self.seen_s = world.time_s

    def seen(self, world):
        return self.point is not None and world.time_s - self.seen_s < Goal.FRESH

    def where(self, world):
        if self.seen(world):
            return self.point
        good = (world.heading_sd_deg < Goal.POSE_HEADING_SD and
                world.seconds_since_landmark < Goal.POSE_FRESH)
        return from_field(world.pose, 0.5 * Field.WIDTH, Field.LENGTH) if good else None
