# SPDX-License-Identifier: Apache-2.0
# The head on the top of the ball (hTrack.trackVisualBall, thesis 2006 section 6.2.1): by projection
# of the top that this image shows to the carpet behind it, which does not depend on how large the
# ball seems; where that fails by trigonometry, from distance and heading. Keeps which of the two it
# was. Loses a ball that crosses the image within a frame or two, and any under the chin.
import kelpie
from lib.geom import polar
from lib.projection import ground_through
from lib.steer import aim_at

CLOSE = 30.0  # cm (facts-2005 section 7.2)


class TrackBall:
    def __init__(self, memory=None):
        self.memory = memory
        self.projected = False  # the last look was by projection

    def head(self, world) -> kelpie.HeadRequest:
        if self.memory is not None:
            note_close(world, self.memory)
        point = by_projection(world.percepts.ball, world)
        self.projected = point is not None
        return aim_at(*point, 0.0) if self.projected else aim_at(*by_trigonometry(world))


def note_close(world, memory) -> None:
    """Remembers a ball that was seen close."""
    ball = world.percepts.ball
    if ball.present and ball.distance < CLOSE:
        memory.close_lost = 0


def by_projection(ball, world):
    """The point of the carpet behind the top of the ball as seen; None when it was not seen, its
    top is out of the image or nothing is behind it."""
    top = ball.centre.y - ball.radius
    if not ball.present or top < 0.0:
        return None
    return ground_through(world, ball.centre.x, top)


def by_trigonometry(world):
    """The ball's place in the robot frame from distance and heading: of the percept, else of the
    estimate."""
    ball = world.percepts.ball
    return polar(ball.distance, ball.heading_deg) if ball.present else believed(world)


def believed(world):
    """Where gps has the ball, in the robot frame."""
    return world.ball.relative.x, world.ball.relative.y
