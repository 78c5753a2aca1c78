# SPDX-License-Identifier: Apache-2.0
# Where a rolling ball goes: where and when it crosses the goalie's own line (its x axis, along
# which a block lies) and the goal line, from the ball filter's position, velocity and stopping
# point. Keeps nothing. A straight way without bounces; what the velocity is wrong by, it is wrong
# by.
import math

from lib.geom import Point
from lib.intercept import DRAG, FRICTION, relative_velocity, rolled

NEVER = math.inf


def seconds_to_roll(distance, speed) -> float:
    """Until a ball of that speed (cm/s) has gone that far (cm); infinite if it stops before.

    Its speed is (v0 + c) exp(-k t) - c with c = FRICTION / DRAG. Newton's steps come from one side,
    since the way is concave in time."""
    if distance <= 0.0:
        return 0.0
    c = FRICTION / DRAG
    if speed <= 0.0 or rolled(speed, NEVER) < distance:
        return NEVER
    t = distance / speed
    for _ in range(6):
        rate = max((speed + c) * math.exp(-DRAG * t) - c, 0.5)
        t += (distance - rolled(speed, t)) / rate
    return t


def crossing(start, velocity, y) -> tuple[Point, float] | None:
    """Where a straight way crosses the line of that y, and how far that is; None if it never comes
    there. Works in any frame."""
    ahead = (y - start[1]) * velocity[1]
    if ahead < 0.0 or velocity[1] == 0.0:
        return None
    share = (y - start[1]) / velocity[1]
    x = start[0] + share * velocity[0]
    return (x, y), math.hypot(x - start[0], y - start[1])


def speed(ball) -> float:
    return math.hypot(ball.velocity.x, ball.velocity.y)


class Shot:
    """A ball on its way to the own goal: `lateral` (cm right of the goalie where it crosses the
    goalie's own x axis) and `seconds` until then, `mouth_x` where it crosses the goal line,
    `speed` (cm/s). None of it if coming() says no."""

    def __init__(self, lateral, seconds, mouth_x, speed):
        self.lateral, self.seconds, self.mouth_x, self.speed = lateral, seconds, mouth_x, speed


def coming(world, beside, short, min_speed) -> Shot | None:
    """The ball as a shot if it is at least that fast, will cross the goal line no farther than
    `beside` (cm) from the mouth and would stop at most `short` (cm) before the line."""
    ball, field = world.ball, world.field
    fast = speed(ball)
    if not ball.present or fast < min_speed or ball.stopping_point.y > short:
        return None
    at_goal = crossing((ball.position.x, ball.position.y), (ball.velocity.x, ball.velocity.y), 0.0)
    if at_goal is None:
        return None
    mouth_x = at_goal[0][0]
    if abs(mouth_x - 0.5 * field.width) > 0.5 * field.goal_width + beside:
        return None
    here = crossing((ball.relative.x, ball.relative.y), relative_velocity(world), 0.0)
    if here is None:
        return None
    return Shot(here[0][0], seconds_to_roll(here[1], fast), mouth_x, fast)
