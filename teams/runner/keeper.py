# SPDX-License-Identifier: Apache-2.0
# The goalie: between the ball and the goal, into the way of a ball that comes, and through one that
# lies in or before its box, which is how it clears. Keeps nothing. Fails against a ball that is
# turned off by somebody just before the goal.
import math

from eyes import off_ahead
from places import go
from plane import along, between, clamp, walk, xy
from run import run

OUT = 26.0           # cm from the goal's middle to its place, on the way to the ball
CLEARS = 32.0        # cm round its box, in which a ball is run through
COMES = 25.0         # cm/s towards the goal
HALF = 32.0          # cm from the middle that it goes to a side
STEPS_S = 2.5        # s; a ball that crosses the line later is not stepped into yet


def clears(world, ball) -> bool:
    """Whether the ball is the goalie's, and nobody of its team is with it."""
    field = world.field
    beside = abs(ball[0] - 0.5 * field.width) - 0.5 * field.box_width
    if beside > CLEARS or ball[1] > field.box_depth + CLEARS:
        return False
    inside = beside < 0.0 and ball[1] < field.box_depth
    here = math.dist(xy(world.pose), ball)
    return inside or all(here < math.dist(xy(mate.pose), ball) for mate in world.teammates)


def place(world, ball) -> tuple:
    """On the way from the ball to the goal's middle; where a rolling ball would cross."""
    middle, velocity = 0.5 * world.field.width, world.ball.velocity
    x, y = along((middle, 0.0), between((middle, -20.0), ball), OUT)
    y = max(12.0, y)   # nearer to the line the hind legs stand in the goal
    if world.ball.seconds_since_seen < 0.3 and velocity.y < -COMES:
        seconds = (ball[1] - y) / -velocity.y
        if 0.0 < seconds < STEPS_S:
            x = ball[0] + seconds * velocity.x
    return clamp(x, middle - HALF, middle + HALF), y


def keep(world, ball):
    """The walk of the goalie; without a ball to the goal's middle, looking up-field."""
    middle = 0.5 * world.field.width
    if ball is None:
        return go(world, (middle, 22.0), (middle, world.field.length), 2.0)
    if clears(world, ball):
        return run(world, ball)
    target = place(world, ball)
    speed = min(38.0, 3.0 * math.dist(xy(world.pose), target))
    return walk(off_ahead(world, target), off_ahead(world, ball), speed)
