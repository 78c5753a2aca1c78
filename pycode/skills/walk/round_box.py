# SPDX-License-Identifier: Apache-2.0
# Goes round the own box to a ball beyond it, by its corners, as fast as it can. Keeps how far the
# next corner is, for the trace. Who walks straight at such a ball is stopped at the box and stands
# there for good. Fails by what the pose is wrong.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import any_way, full_ahead
from safety import own_box
from skills.head.track_ball import TrackBall

REACH = 14.0         # cm from the neck to a ball that is played: so far the way has to be free
FREE = 2.0           # cm about the box that the straight way must cross; who goes round it already
                     # keeps what own_box.round_box() does


def needed(world, goes_round=False) -> bool:
    """Whether the own box lies on the way to the ball. `goes_round`: it does so already."""
    here, ball = point_of(world.pose), point_of(world.ball)
    away = math.dist(here, ball)
    if not world.ball.present or away < REACH:
        return False
    share = 1.0 - REACH / away
    place = here[0] + share * (ball[0] - here[0]), here[1] + share * (ball[1] - here[1])
    margin = own_box.ROUND if goes_round else FREE
    return own_box.crosses(*own_box.clear_of(world.field, margin), here, place)


class RoundBox(Skill):
    NAME = 'round_box'

    def __init__(self, memory):
        self.track = TrackBall(memory)
        self.away = 0.0

    def step(self, world) -> kelpie.Command:
        here = point_of(world.pose)
        corner = own_box.round_box(world.field, here, point_of(world.ball))
        self.away = math.dist(here, corner)
        ahead = wrap(direction(here, corner) - world.pose.heading_deg)
        walk = any_way(ahead, ahead, full_ahead(ahead))
        return kelpie.Command(walk=walk, head=self.track.step(world))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, '', '{} cm to where it turns', self.away))
        self.track.explain(trace)
