# SPDX-License-Identifier: Apache-2.0
# Takes the ball from an opponent who runs with it: steps into its way, where the ball will be when
# the robot gets there, and runs through it from near. Keeps which of the two, and how far it is.
# Fails for a ball that turns off meanwhile.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import any_way, full_ahead
from skills.ball.run_ball import RunBall
from skills.head.track_ball import TrackBall

FROM = 170.0         # cm to the ball, within which it is challenged,
LEFT = 200.0         # and so far until it is left again
BESIDE = 1.4         # cm beside the ball's course for each ahead of it, at most: else it is past
                     # before the robot is there
NEAR = 50.0          # cm to the ball, from where on it is run at
BALL = 30.0          # cm/s of who runs with it: the runners of 2005 made 25 to 30,
ROBOT = 40.0         # and of who steps into its way
LEAST = 15.0         # cm ahead of the ball
SLOW = 20.0          # cm/s: a slower ball is taken to go to the own goal


def course(world, ball) -> tuple:
    """The direction in which the ball goes on the field, as a vector of length 1."""
    dx, dy = world.ball.velocity.x, world.ball.velocity.y
    if math.hypot(dx, dy) < SLOW or dy > 0.0:
        dx, dy = 0.5 * world.field.width - ball[0], -ball[1]
    length = max(math.hypot(dx, dy), 1e-6)
    return dx / length, dy / length


def off_course(ball, way, here) -> tuple:
    """(cm ahead of the ball on its course, cm beside that) of who is at `here`."""
    dx, dy = here[0] - ball[0], here[1] - ball[1]
    return dx * way[0] + dy * way[1], abs(dx * way[1] - dy * way[0])


def meeting(ball, way, here) -> tuple:
    """Where the ball will be when the robot has gone as far as it is beside the ball's course."""
    ahead, beside = off_course(ball, way, here)
    s = clamp(BALL * beside / ROBOT, LEAST, max(LEAST, ahead))
    return ball[0] + s * way[0], ball[1] + s * way[1]


def within_reach(world, challenges=False) -> bool:
    """Whether it can step into the ball's way. `challenges`: it does so already."""
    if not world.ball.present:
        return False
    ball, here = point_of(world.ball), point_of(world.pose)
    ahead, beside = off_course(ball, course(world, ball), here)
    return math.dist(ball, here) < (LEFT if challenges else FROM) and beside < BESIDE * ahead


class Challenge(Skill):
    NAME = 'challenge'

    def __init__(self, memory):
        self.track, self.run = TrackBall(memory), RunBall(memory)
        self.branch, self.away = 'steps_in', 0.0

    def step(self, world) -> kelpie.Command:
        here, ball = point_of(world.pose), point_of(world.ball)
        place = meeting(ball, course(world, ball), here)
        self.away = math.dist(here, place)
        self.branch = 'runs_through' if math.dist(here, ball) < NEAR else 'steps_in'
        if self.branch == 'runs_through':
            return self.run.step(world)
        ahead = wrap(direction(here, place) - world.pose.heading_deg)
        walk = any_way(ahead, ahead, full_ahead(ahead))
        return kelpie.Command(walk=walk, head=self.track.step(world))

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, self.branch, 'its way is {} cm off',
                      self.away))
        self.track.explain(trace)
