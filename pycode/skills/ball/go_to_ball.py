# SPDX-License-Identifier: Apache-2.0
# Walks to the ball, or rather to a place behind it as seen from the goal, fast and facing ahead.
# Keeps nothing. Knows no obstacles and no field borders: it walks straight.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import Point, clamp, heading


class Approach:
    SLOW_DOWN = 45.0         # distance from which the speed falls
    SPEED = 34.0  # cm/s
    MIN_SPEED = 10.0         # cm/s
    TURN_GAIN = 1.8          # deg/s per deg
    TURN_SPEED = 70.0  # deg/s
    TURN_FIRST = 50.0        # a ball farther off: turn on the spot
    NEAR = 28.0              # distance at which lining up begins
    BEHIND = 22.0            # aim at this far behind the ball, seen from the goal
    TIME = 25.0  # s


def behind(ball, goal_point) -> Point:
    """The place to stand at: BEHIND cm from the ball on the line from the goal through it."""
    if goal_point is None:
        return ball
    dx, dy = ball[0] - goal_point[0], ball[1] - goal_point[1]
    away = max(math.hypot(dx, dy), 1.0)
    return ball[0] + Approach.BEHIND * dx / away, ball[1] + Approach.BEHIND * dy / away


class GoToBall(Skill):
    NAME = 'go_to_ball'

    def step(self, world, goal_point: Point | None) -> kelpie.WalkRequest:
        ball = (world.ball.relative.x, world.ball.relative.y)
        place = behind(ball, goal_point)
        # A place beyond the ball would be reached through it: go to the ball and circle there.
        if math.hypot(*place) > world.ball.distance:
            place = ball
        off_deg = heading(*place)
        turn = clamp(Approach.TURN_GAIN * off_deg, -Approach.TURN_SPEED, Approach.TURN_SPEED)
        if abs(off_deg) > Approach.TURN_FIRST:
            return kelpie.WalkRequest(turn_deg=turn)
        share = clamp(world.ball.distance / Approach.SLOW_DOWN, 0.0, 1.0)
        speed = max(Approach.MIN_SPEED, Approach.SPEED * share)
        return kelpie.WalkRequest(forward=speed * math.cos(math.radians(off_deg)), turn_deg=turn)
