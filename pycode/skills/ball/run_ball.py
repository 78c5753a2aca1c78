# SPDX-License-Identifier: Apache-2.0
# Runs with the ball: a curve that arrives behind it at full speed, then through it, so that it
# rolls ahead of the chest and is run after, with small turns to where situation/run_way.py wants
# it; and shoots without a stop as soon as that is likely to be a goal. There is no grab in it, so
# that no rule of held balls applies. Keeps the last way, for the trace, and the kick. It fails
# where the ball's place is wrong by its radius: the ball slips off to a side, and a new curve is
# needed.
import math

import kelpie
from arbiter.machine import Machine
from lib.geom import clamp, wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import FULL, any_way
from situation.run_way import opponents, run_way
from situation.snap_shot import snap_shot
from skills.head.track_ball import TrackBall
from skills.motion.kick import Kick

CONSTANTS = kelpie.constants.run  # behaviour/constants.toml: defaults and ranges
ROUND = CONSTANTS.round    # cm from the ball to the way round it: paws reach 18 ahead of the neck
CURVE = CONSTANTS.curve    # deg that the way leads aside of the ball for each deg off its line,
STEER = CONSTANTS.steer    # deg so, once it runs: a paw that hits the side turns the ball by more
BEHIND = CONSTANTS.behind  # deg off the line within which the ball is run at
LEAD_S = CONSTANTS.lead    # s that the ball rolls until the legs answer
PUSHED_OUT = 2.0     # deg aside for each cm that the ball is nearer than ROUND
SEEN_S = 0.3         # s; of a ball seen longer ago the velocity says nothing
TURNS_FIRST = 60.0   # deg off ahead of who walks slowly meanwhile,
SLOWLY = 10.0        # cm/s: the legs go fast only ahead
AFTER_SHOT = 60.0    # cm ahead where the ball is looked for, to the side that the kick sends it


class RunBall(Machine):
    NAME = 'run_ball'

    def __init__(self, memory):
        super().__init__(self.runs)
        self.memory = memory
        self.track = TrackBall(memory)
        self.branch, self.way, self.off = 'curve', 0.0, 0.0

    @property
    def committed(self) -> bool:
        return self.state == self.shoots

    @property
    def done(self) -> bool:
        return self.state == self.ended

    def runs(self, world):
        shot = snap_shot(world)
        if shot is not None:
            return self.enter(world, self.shoots, Kick(world, shot[0]),
                              'a goal with a chance of {}', shot[1])
        ball = led(world.ball)
        here, facing = point_of(world.pose), world.pose.heading_deg
        away, bearing = math.dist(here, ball), direction(here, ball)
        self.way = run_way(world.field, ball, opponents(world))
        self.off = wrap(self.way - bearing)
        ahead = wrap(bearing - aside(away, self.off) - facing)
        rounds = away < 2.0 * ROUND and abs(self.off) > BEHIND
        self.branch = 'round' if rounds else 'push' if abs(self.off) <= BEHIND else 'curve'
        face = wrap(bearing - facing) if rounds else ahead
        speed = FULL if rounds or abs(ahead) < TURNS_FIRST else SLOWLY
        return kelpie.Command(walk=any_way(ahead, face, speed), head=self.track.step(world))

    def shoots(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            kick = self.skill.which
            self.hint = kelpie.KICKS[kick].hint or (AFTER_SHOT, 0.0)
            return self.enter(world, self.ended, None, 'kicked')
        return kelpie.Command(head=self.track.step(world), motion=motion)

    def ended(self, world):
        return kelpie.Command(head=self.track.step(world))

    def explain(self, trace) -> None:
        if self.state != self.runs:
            return super().explain(trace)
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
