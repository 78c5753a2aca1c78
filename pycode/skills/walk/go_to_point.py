# SPDX-License-Identifier: Apache-2.0
# Walks to a point of the field by the pose: turns on the spot until it faces the point, then ahead,
# with small corrections only, since odometry is best when one direction rules (thesis 2004 section
# 4.1.5). Stops, looks once more at what helps the pose, and corrects what is left. Keeps whether it
# turns and since when it stands at the point. Is as wrong as the pose.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import Point, clamp, from_field, heading

from skills.head.watch_field import WatchField


class Challenge:
    STAND_OFF_CENTRE = 65.0  # the map is made from here, behind and beyond the middle
    STAND_NEAR = 12.0  # cm
    STAND_TIME = 12.0        # s; then map from where it is
    MAP_ROUNDS = 3  # rounds of the head
    MIN_STAGE = 10.0         # s; play halted earlier is the start
    SURE_SD = 15.0           # cm
    SURE_HEADING_SD = 6.0    # deg
    SURE_WEIGHT = 0.6        # weight of the best mode
    LOST_SD = 40.0           # cm
    NEAR = 3.0               # cm from a point that count as there,
    NEAR_BEHIND = 6.0        # cm from the place behind it: beyond STEP_BACK of the point
    SETTLE = 0.8             # s that it stands before it announces the point
    ANNOUNCE_TIME = 0.8  # s
    SPEED = 32.0  # cm/s
    SLOW = 7.0  # cm/s
    SLOW_DOWN = 1.3          # cm/s per cm
    FACE_FIRST = 6.0         # deg; turning on the spot ends
    FACE_AGAIN = 22.0        # deg; turning on the spot begins again
    FACE_NEAR = 170.0        # deg cm: 3 cm to the side
    STEP_BACK = 15.0         # a point nearer than this and behind is backed to
    TURN_GAIN = 2.0  # deg/s per deg
    TURN_SPEED = 80.0  # deg/s


class GoToPoint(Skill):
    NAME = 'go_to_point'

    def __init__(self, point: Point, near, first: Point | None = None):
        self.point = point   # of the field
        self.first = first   # the place to go to before it, or None
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
        x, y = from_field(world.pose, *(self.first or self.point))
        away = math.hypot(x, y)
        if self.first is not None and away < Challenge.NEAR_BEHIND:
            self.first, self.turning = None, True
            return kelpie.WalkRequest()
        # Once there, errors of the pose alone must not set it walking again.
        if away < (self.near if self.still_s is None else 2.0 * self.near):
            self.still_s = self.still_s if self.still_s is not None else world.time_s
            return kelpie.WalkRequest()
        self.still_s = None
        off_deg = heading(x, y)
        facing = Challenge.FACE_FIRST if self.turning else Challenge.FACE_AGAIN
        if away < Challenge.STEP_BACK and abs(off_deg) > 90.0:
            return kelpie.WalkRequest(forward=-Challenge.SLOW)
        self.turning = abs(off_deg) > max(facing, Challenge.FACE_NEAR / away)
        turn = clamp(Challenge.TURN_GAIN * off_deg, -Challenge.TURN_SPEED, Challenge.TURN_SPEED)
        if self.turning:
            return kelpie.WalkRequest(turn_deg=turn)
        speed = clamp(Challenge.SLOW_DOWN * away, Challenge.SLOW, Challenge.SPEED)
        return kelpie.WalkRequest(forward=speed, turn_deg=0.5 * turn)

    def explain(self, trace) -> None:
        branch = 'stand' if self.still_s is not None else 'turn' if self.turning else 'walk'
        if self.first is not None:
            branch = 'go_behind'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch, 'the point is ({}, {})', *self.point))
        self.watch.explain(trace)
