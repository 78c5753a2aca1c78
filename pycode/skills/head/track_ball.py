# SPDX-License-Identifier: Apache-2.0
# The head on the top of the ball (hTrack.trackVisualBall, thesis 2006 section 6.2.1): by projection
# of the top that this image shows to the carpet behind it, which does not depend on how large the
# ball seems; where that fails by trigonometry, from distance and heading. Aims at where ball and
# robot will be when the head gets there. Keeps which of the two it was. Loses a ball that crosses
# the image within a frame or two, and any under the chin.
import math

import kelpie
from arbiter.skill import Skill
from lib import rulebook
from lib.geom import Point, moved, polar
from lib.intercept import relative_velocity, rolls
from lib.projection import ground_through
from lib.shared_gaze import SharedGaze
from lib.steer import BALL_TOP, aim_at

CLOSE = 30.0      # cm (facts-2005 section 7.2)
NEAR = 28.0       # cm; a ball nearer than this is needed in the middle of the image
# From an image to the head's answer to it on the physical body. With it balls that roll at 20 to 90
# cm/s are in the middle third of the image, across and down, in 0.90 of the frames, else in 0.80.
LATE_FRAMES = 4
FRAMES_PER_S = 30.0  # 1/s


class TrackBall(Skill):
    NAME = 'track_ball'

    def __init__(self, memory=None):
        self.memory = memory
        self.shared = SharedGaze()
        self.projected = False  # the last look was by projection

    def step(self, world) -> kelpie.HeadRequest:
        if self.memory is not None:
            note_close(world, self.memory)
        point = by_projection(world.percepts.ball, world)
        self.projected = point is not None
        if self.projected:
            return self.gaze(world, led(world, point), 0.0)
        return self.gaze(world, led(world, by_trigonometry(world)), BALL_TOP)

    def gaze(self, world, point, height) -> kelpie.HeadRequest:
        """At the ball; beside it, to see a landmark too, while it lies still and is not near."""
        shares = rulebook.of(world).SHARES_GAZE
        if not shares or world.ball.distance < NEAR or rolls(world.ball):
            return aim_at(*point, height)
        return self.shared.beside(world, point, height)


def note_close(world, memory) -> None:
    """Remembers a ball that was seen close."""
    ball = world.percepts.ball
    if ball.present and ball.distance < CLOSE:
        memory.saw_close()


def by_projection(ball, world):
    """The point of the carpet behind the top of the ball as seen; None when it was not seen, its
    top is out of the image or nothing is behind it."""
    top = ball.centre.y - ball.radius
    if not ball.present or top < 0.0:
        return None
    return ground_through(world, ball.centre.x, top)


def led(world, point) -> Point:
    """A point in line with the ball, moved on as the ball rolls and the robot walks meanwhile."""
    x, y = point
    if not rulebook.of(world).LEADS_BALL:
        return x, y
    if rolls(world.ball):
        vx, vy = relative_velocity(world)
        farther = math.hypot(x, y) / max(world.ball.distance, 1.0)
        x += farther * vx * LATE_FRAMES / FRAMES_PER_S
        y += farther * vy * LATE_FRAMES / FRAMES_PER_S
    return moved(x, y, world.odometry, LATE_FRAMES)


def by_trigonometry(world):
    """The ball's place in the robot frame from distance and heading: of the percept, else of the
    estimate."""
    ball = world.percepts.ball
    return polar(ball.distance, ball.heading_deg) if ball.present else believed(world)


def believed(world):
    """Where gps has the ball, in the robot frame."""
    return world.ball.relative.x, world.ball.relative.y
