# SPDX-License-Identifier: Apache-2.0
# Walks to a point of the field by the pose: turns on the spot until it faces the point, then ahead,
# with small corrections only, since odometry is best when one direction rules (thesis 2004 section
# 4.1.5). Stops, looks once more at what helps the pose, and corrects what is left. Keeps whether it
# turns and since when it stands at the point. Is as wrong as the pose.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import Point, clamp, from_field, heading
from lib.tune import Challenge
from skills.head.watch_field import WatchField


class GoToPoint(Skill):
    NAME = 'go_to_point'

    def __init__(self, point: Point, near):
        self.point = point   # of the field
        self.near = near     # cm that count as there
        self.watch = WatchField()
        self.turning = True
        self.still_s = None  # since when it stands there

    def step(self, world) -> kelpie.Command:
        """`done`: it stands at the point, and has done so for a while."""
        command = kelpie.Command(walk=self.walk_there(world), head=self.watch.step(world))
        self.done = self.still_s is not None and world.time_s - self.still_s > Challenge.SETTLE
        return command

    def walk_there(self, world) -> kelpie.WalkRequest:
        x, y = from_field(world.pose, *self.point)
        away = math.hypot(x, y)
        # Once there, errors of the pose alone must not set it walking again.
        if away < (self.near if self.still_s is None else 2.0 * self.near):
            self.still_s = self.still_s if self.still_s is not None else world.time_s
            return kelpie.WalkRequest()
        self.still_s = None
        aside = heading(x, y)
        facing = Challenge.FACE_FIRST if self.turning else Challenge.FACE_AGAIN
        if away < Challenge.STEP_BACK and abs(aside) > 90.0:
            return kelpie.WalkRequest(forward=-Challenge.SLOW)
        self.turning = abs(aside) > max(facing, Challenge.FACE_NEAR / away)
        turn = clamp(Challenge.TURN_GAIN * aside, -Challenge.TURN_SPEED, Challenge.TURN_SPEED)
        if self.turning:
            return kelpie.WalkRequest(turn_deg=turn)
        speed = clamp(Challenge.SLOW_DOWN * away, Challenge.SLOW, Challenge.SPEED)
        return kelpie.WalkRequest(forward=speed, turn_deg=0.5 * turn)

    def explain(self, trace) -> None:
        branch = 'stand' if self.still_s is not None else 'turn' if self.turning else 'walk'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch, 'the point is ({}, {})', *self.point))
