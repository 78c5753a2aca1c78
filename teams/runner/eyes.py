# SPDX-License-Identifier: Apache-2.0
# Where the ball is, by the own eyes or by the mates', and where the head looks. Keeps since when
# nobody knows of the ball and to which side it was last. Fails as poses do: a mate's ball is off by
# the errors of two of them.
import math

import kelpie
from plane import between, clamp, wrap, xy

OWN_S = 1.0          # s for which an unseen ball is believed where it was: a push hides it so long
TEAM_S = 1.5         # s for which the mates' ball is gone for
SWEEP_S = 1.6        # s of a sweep of the head there and back
SPIN_S = 3.0         # s of turning on the spot, once round; then it walks on for as long and looks
SPIN = 130.0         # deg/s
GLANCE_S = 2.4       # s from one look at the field's marks to the next,
GLANCE_FOR_S = 0.5   # s that it takes
GLANCE_FAR = 55.0    # cm; a nearer ball is not let out of sight
BALL_TOP = 8.4       # cm


class Eyes:
    def __init__(self):
        self.side = 1.0        # to which the ball was last, left positive
        self.lost_s = None     # since when nobody knows of it

    def ball(self, world):
        """Where it is on the field, or None; to be asked once a frame."""
        own, team, place = world.ball, world.team_ball, None
        if own.present and own.seconds_since_seen < OWN_S:
            place = xy(own)
        elif team.present and team.seconds_since_seen < TEAM_S:
            place = xy(team)
        if place is not None:
            self.side, self.lost_s = math.copysign(1.0, off_ahead(world, place)), None
        elif self.lost_s is None:
            self.lost_s = world.time_s
        return place

    def look(self, world, ball) -> kelpie.HeadRequest:
        """At the ball, from time to time at a mark of the field, without a ball all round."""
        if ball is None:
            return sweep(world)
        if world.ball.seconds_since_seen > OWN_S:
            return aim(off_ahead(world, ball), -12.0)
        if world.ball.distance > GLANCE_FAR and world.time_s % GLANCE_S < GLANCE_FOR_S:
            now = world.head.head_pan_deg
            offs = [off_ahead(world, xy(mark)) for mark in world.field.landmarks]
            return aim(min(offs, key=lambda off: abs(off - now)), 3.0)
        top = kelpie.Point3(x=world.ball.relative.x, y=world.ball.relative.y, z=BALL_TOP)
        return kelpie.HeadRequest(aim=kelpie.AIM_POINT, target=top)

    def search(self, world) -> kelpie.WalkRequest:
        """For a lost ball a spin, then a walk in the round: what hid it no longer does."""
        if (world.time_s - self.lost_s) % (2.0 * SPIN_S) < SPIN_S:
            return kelpie.WalkRequest(turn_deg=self.side * SPIN)
        return kelpie.WalkRequest(forward=30.0, turn_deg=-25.0 * self.side)


def off_ahead(world, place) -> float:
    """Degrees left of ahead to a point of the field."""
    return wrap(between(xy(world.pose), place) - world.pose.heading_deg)


def sweep(world) -> kelpie.HeadRequest:
    turns = world.time_s / SWEEP_S
    return aim(70.0 * math.sin(2.0 * math.pi * turns), -30.0 if int(turns) % 2 else -12.0)


def aim(direction, elevation) -> kelpie.HeadRequest:
    return kelpie.HeadRequest(aim=kelpie.AIM_DIRECTION, elevation_deg=elevation,
                              direction_deg=clamp(direction, -88.0, 88.0))
