# SPDX-License-Identifier: Apache-2.0
# Runs with the ball: a curve that arrives behind it at full speed, then through it, so that it
# rolls ahead and is run after, with small turns to the goal and past who stands in the way. Keeps
# nothing. It never grabs or waits; it fails where the ball's place is wrong by its radius, as then
# the ball slips off to a side and a new curve is needed.
import math

from plane import FULL, along, between, clamp, walk, wrap, xy

ROUND = 24.0         # cm from the ball to the way round it: paws reach 18 ahead of the neck base
CURVE = 1.4          # deg that the way leads aside of the ball for each deg that it is off its line
STEER = 0.6          # so, once it runs: a paw that hits the ball's side turns it by more
LEAD_S = 0.25        # s that the ball rolls until the legs answer
BEHIND = 35.0        # deg off the line within which the ball is run at
GOAL_NEAR = 110.0    # cm from the goal, from where on the free side of the mouth is run at
ASIDE = 17.0         # cm from the goal's middle then
IN_WAY = 110.0       # cm ahead of the ball in which opponents are gone past,
BODY = 32.0          # cm by which: half of two robots' widths and the ball
SEEN_S = 2.0         # s; opponents seen longer ago have moved
TURNS = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0, 60.0, -60.0)  # deg off the goal
EDGE = 22.0          # cm from a side line, over which the ball would go
LINE = 80.0          # cm to their goal line, from where on a way beside the mouth leads out
POST = 8.0           # cm from a post that the ball keeps


def goal_point(world, ball, others) -> tuple:
    """The goal's middle; from near by the side of it that opponents before it leave free."""
    middle, line = 0.5 * world.field.width, world.field.length
    keepers = [x for x, y in others if y > line - 50.0 and abs(x - middle) < 50.0]
    if math.dist(ball, (middle, line)) > GOAL_NEAR or not keepers:
        return middle, line + 10.0
    return middle + (ASIDE if sum(keepers) / len(keepers) < middle else -ASIDE), line + 10.0


def in_way(others, ball, degrees) -> float:
    """How much stands on the way from the ball in a direction: 0, up to about 1 for each body."""
    total = 0.0
    for other in others:
        away = math.dist(ball, other)
        off = math.radians(wrap(between(ball, other) - degrees))
        if 0.0 < math.cos(off) * away < IN_WAY:
            total += max(0.0, 1.0 - abs(math.sin(off)) * away / BODY) * (1.2 - away / IN_WAY)
    return total


def leaves(field, ball, degrees) -> bool:
    """Whether the ball would go over a line on that way, but for into the goal."""
    if not EDGE < along(ball, degrees, 50.0)[0] < field.width - EDGE:
        return True
    left, ahead = field.length - ball[1], math.sin(math.radians(degrees))
    if left > LINE or ahead <= 0.05:
        return False
    crossing = along(ball, degrees, left / ahead)[0]
    return abs(crossing - 0.5 * field.width) > 0.5 * field.goal_width - POST


def direction(world, ball) -> float:
    """Where the ball shall go: to the goal, turned as little as takes it past opponents. A body
    full in the way costs as much as 75 deg, a line as 60."""
    others = [xy(one) for one in world.opponents if one.seconds_since_seen < SEEN_S]
    goal = between(ball, goal_point(world, ball, others))

    def cost(turn):
        out = 60.0 if leaves(world.field, ball, goal + turn) else 0.0
        return abs(turn) + 75.0 * in_way(others, ball, goal + turn) + out

    return goal + min(TURNS, key=cost)


def run(world, ball):
    """The walk of who has the ball, or is the next to get it."""
    here, facing = xy(world.pose), world.pose.heading_deg
    if world.ball.seconds_since_seen < 0.3:
        velocity = world.ball.velocity
        ball = ball[0] + LEAD_S * velocity.x, ball[1] + LEAD_S * velocity.y
    away, bearing = math.dist(here, ball), between(here, ball)
    off = wrap(direction(world, ball) - bearing)
    # As far aside as keeps off the ball: its tangent, nearer than that straight aside and outwards.
    tangent = math.degrees(math.asin(min(1.0, ROUND / max(away, 1.0))))
    if away < ROUND:
        tangent += 2.0 * (ROUND - away)
    aside = clamp((CURVE if abs(off) > BEHIND else STEER) * off, -tangent, tangent)
    way = wrap(bearing - aside - facing)
    near = away < 2.0 * ROUND and abs(off) > BEHIND
    face = wrap(bearing - facing) if near else way
    # Who looks elsewhere turns first: the legs go fast only ahead.
    return walk(way, face, FULL if near or abs(way) < 60.0 else 10.0)
