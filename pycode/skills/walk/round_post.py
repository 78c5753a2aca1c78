# SPDX-License-Identifier: Apache-2.0
# Goes round a post of the opponents' goal to a ball behind it: first to a place before the ball, up
# to which the way is free, facing the ball. Keeps how far that is, for the trace. A robot whose
# shoulder leans on a post walks on the spot until the referee ends it. Fails by what the pose is
# wrong beyond CLEAR.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, wrap
from lib.goalie_places import direction
from lib.goalie_places import posts as own_posts
from lib.paths import point_of
from lib.steer import FULL, any_way
from skills.head.track_ball import TrackBall

CLEAR = 17.0         # cm from a post to the way of a neck: half a body, and what the pose is wrong,
LEFT = 3.0           # cm more until the way is free again
BESIDE = 8.0         # cm before the ball, from where on a post is beside it and in nobody's way
BEFORE = 38.0        # cm before the goal line that the place lies: a robot's length and the paws
EDGE = 16.0          # cm from a side line
GAIN = 4.0           # cm/s for each cm that is left


def posts(field) -> tuple:
    """(x, y) of the two, cm on the field."""
    return tuple((x, field.length) for x, _ in own_posts(field))


def in_way(field, here, ball, more) -> bool:
    """Whether a post stands beside the straight way to the ball, clearly before it. `more`: cm by
    which both count later, for who goes round it already."""
    way = math.dist(here, ball)
    if way < 1.0:
        return False
    ux, uy = (ball[0] - here[0]) / way, (ball[1] - here[1]) / way
    for x, y in posts(field):
        dx, dy = x - here[0], y - here[1]
        ahead, aside = dx * ux + dy * uy, abs(dx * uy - dy * ux)
        if -CLEAR < ahead < way - BESIDE + more and aside < CLEAR + more:
            return True
    return False


def needed(world, goes_round=False) -> bool:
    """`goes_round`: it does so already."""
    ball = world.ball
    return ball.present and in_way(world.field, point_of(world.pose), point_of(ball),
                                   LEFT if goes_round else 0.0)


class RoundPost(Skill):
    NAME = 'round_post'

    def __init__(self, memory):
        self.track = TrackBall(memory)
        self.away = 0.0

    def step(self, world) -> kelpie.Command:
        here, facing, field = point_of(world.pose), world.pose.heading_deg, world.field
        place = clamp(world.ball.position.x, EDGE, field.width - EDGE), field.length - BEFORE
        self.away = math.dist(here, place)
        way = wrap(direction(here, place) - facing)
        walk = any_way(way, world.ball.heading_deg, min(FULL, GAIN * self.away))
        return kelpie.Command(walk=walk, head=self.track.step(world))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, '', '{} cm to the place before the ball',
                      self.away))
        self.track.explain(trace)
