# SPDX-License-Identifier: Apache-2.0
# A gaze that keeps the ball in the image but not in its middle: turned to the side and up, as far
# as the ball stays whole, so that a landmark comes into the image as well. Whoever only looks at
# the ball sees what happens to be behind it. A wrong pose turns it to where no landmark is,
# which costs nothing: the ball is still seen.
import math

import kelpie
from lib.geom import Point, clamp, heading, polar, wrap
from lib.landmarks import FARTHEST, NEAREST
from lib.steer import aim_at

IMAGE_HALF_WIDTH = 28.4    # deg from the middle of the image to its side,
IMAGE_UP = 22.6       # and to its upper edge
INSIDE = 6.0          # of a landmark's middle from that side: a third of a beacon's height
MAX_PAN_OFF = 14.0        # the ball is moved at most; at 1 m it is 5 deg wide
HORIZON_IN = 5.0      # deg of the image above the horizon that are wanted
EYES = 17.0           # cm that the camera is above the top of the ball
BALL = 8.6            # cm
ALL_ROUND = 180.0     # deg
MARGIN = 4.0          # deg between the ball and the lower edge
EVERY = 3             # frames


def pan_for(world, ball_pan) -> float:
    """How far (deg to the left) the view turns from the ball so that the landmark nearest to it
    comes into the image; 0 when one is in it already, or none can be."""
    place, view = world.pose.position, world.pose.heading_deg + ball_pan
    x, y, best = place.x, place.y, ALL_ROUND
    for mark in world.field.landmarks:
        dx, dy = mark.position.x - x, mark.position.y - y
        if NEAREST <= math.hypot(dx, dy) <= FARTHEST:
            off = wrap(math.degrees(math.atan2(dy, dx)) - view)
            best = off if abs(off) < abs(best) else best
    needed = abs(best) - (IMAGE_HALF_WIDTH - INSIDE)
    return math.copysign(needed, best) if 0.0 < needed <= MAX_PAN_OFF else 0.0


def up_for(distance) -> float:
    """How far (deg) the view is raised above a ball at that distance (cm) for the horizon to be in
    the image, at most until the ball touches the lower edge."""
    down = math.degrees(math.atan2(EYES, distance))
    wide = math.degrees(BALL / max(distance, BALL))
    wanted = down - (IMAGE_UP - HORIZON_IN)
    return clamp(wanted, 0.0, max(0.0, IMAGE_UP - MARGIN - wide))


class SharedGaze:
    """Keeps how far it turns to the side, worked out in every third frame: six landmarks are a
    twelfth of what an attacker may spend, and in a tenth of a second they hardly move."""

    def __init__(self):
        self.pan_off, self.frames = 0.0, 0

    def beside(self, world, point: Point, height) -> kelpie.HeadRequest:
        """The view that keeps a ball at that point of the robot frame (cm) and that height, and
        shows what else it can."""
        distance, pan = math.hypot(*point), heading(*point)
        if self.frames <= 0:
            self.pan_off, self.frames = pan_for(world, pan), EVERY
        self.frames -= 1
        up = distance * math.tan(math.radians(up_for(world.ball.distance)))
        return aim_at(*polar(distance, pan + self.pan_off), height + up)
