# SPDX-License-Identifier: Apache-2.0
# Runs with the ball: a curve that arrives behind it at full speed, then through it, so that it
# rolls ahead of the chest and is run after, with small turns to where situation/run_way.py wants
# it. There is no grab in it, so that no rule of held balls applies. Keeps the last way, for the
# trace. It fails where the ball's place is wrong by its radius: the ball slips off to a side, and a
# new curve is needed.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import FULL, any_way, full_ahead
from situation.about_ball import opponents
from situation.run_way import run_way
from skills.head.track_ball import TrackBall

CONSTANTS = kelpie.constants.run  # behaviour/constants.toml: defaults and ranges
ROUND = CONSTANTS.round    # cm from the ball to the way round it: paws reach 18 ahead of the neck
CURVE = CONSTANTS.curve    # deg that the way leads aside of the ball for each deg off its line,
STEER = CONSTANTS.steer    # deg so, once it runs: a paw that hits the side turns the ball by more
BEHIND = CONSTANTS.behind  # deg off the line within which the ball is run at
LEAD_S = CONSTANTS.lead    # s that the ball rolls until the legs answer
PUSHED_OUT = 2.0     # deg aside for each cm that the ball is nearer than ROUND
SEEN_S = 0.3         # s; of a ball seen longer ago the velocity says nothing


class RunBall(Skill):
    NAME = 'run_ball'

    def __init__(self, memory):
        self.memory, self.track = memory, TrackBall(memory)
        self.branch, self.way, self.off = 'curve', 0.0, 0.0

    def step(self, world) -> kelpie.Command:
        ball, here = led(world.ball), point_of(world.pose)
        self.way = run_way(world.field, ball, opponents(world, self.memory))
        self.off = wrap(self.way - direction(here, ball))
        return kelpie.Command(walk=self.at_ball(world, here, ball), head=self.track.step(world))

    def at_ball(self, world, here, ball) -> kelpie.WalkRequest:
        away, bearing = math.dist(here, ball), direction(here, ball)
        facing = world.pose.heading_deg
        ahead = wrap(bearing - aside(away, self.off) - facing)
        rounds = away < 2.0 * ROUND and abs(self.off) > BEHIND
        self.branch = 'round' if rounds else 'push' if abs(self.off) <= BEHIND else 'curve'
        face = wrap(bearing - facing) if rounds else ahead
        return any_way(ahead, face, FULL if rounds else full_ahead(ahead))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, self.branch,
                      'the ball shall go to {} deg, {} deg off the way to it', wrap(self.way),
                      self.off))
        self.track.explain(trace)


def led(ball) -> tuple:
    """Where on the field the ball will be when the legs answer."""
    x, y = point_of(ball)
    if ball.seconds_since_seen > SEEN_S:
        return x, y
    return x + LEAD_S * ball.velocity.x, y + LEAD_S * ball.velocity.y


def aside(away, off) -> float:
    """Degrees by which the way to a ball so many cm away leads past it, on the side from which it
    is pushed: as the ball is off its line, but no farther aside than the tangent of the circle
    round it, nearer than that straight aside and outwards."""
    tangent = math.degrees(math.asin(min(1.0, ROUND / max(away, 1.0))))
    if away < ROUND:
        tangent += PUSHED_OUT * (ROUND - away)
    return clamp((CURVE if abs(off) > BEHIND else STEER) * off, -tangent, tangent)
