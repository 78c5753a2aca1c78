# SPDX-License-Identifier: Apache-2.0
# Where a ball that is run with shall go: to the goal, turned off by no more than takes it past the
# opponents in the way and keeps it on the field. Plain functions from the field, a ball and the
# places of others, in cm and degrees of the field. They keep nothing. Opponents count as standing
# where they were seen: past one that runs along beside the ball the way is chosen too late.
import math

import kelpie
from lib.goalie_places import direction

CONSTANTS = kelpie.constants.run  # behaviour/constants.toml: defaults and ranges
TURNS = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0, 60.0, -60.0)  # deg off the goal
IN_WAY = CONSTANTS.in_way  # cm ahead of the ball within which opponents are gone past,
BODY = CONSTANTS.body      # cm beside them: half of two robots' widths and the ball
BODY_COST = CONSTANTS.body_cost  # deg of turn that a body full in the way is worth
PRESSED = CONSTANTS.pressed  # cm from an opponent to the ball: it is there when a grab ends, after
                             # 1.3 s and the turn,
GUARDED = 50.0       # cm of one that guards its goal,
FREED = 20.0         # cm more until the ball is free again
GOAL_NEAR = 110.0    # cm from the goal, from where on the free side of its mouth is run at,
ASIDE = 17.0         # cm from its middle
KEEPER_AT = 50.0     # cm before the mouth's middle and beside it: who stands there guards it
BEYOND = 10.0        # cm behind the line that is run to
EDGE = 22.0          # cm from a side line, over which the ball would go,
AHEAD = 50.0         # cm further on
OUT_COST = 60.0      # deg of turn
LINE = 80.0          # cm to their goal line, from where on a way beside the mouth leads out
POST = 8.0           # cm from a post that the ball keeps


def pressed(field, ball, others, runs) -> bool:
    """Whether an opponent is so near to the ball that nothing else than running with it will come
    to its end. `runs`: it does so already."""
    more = FREED if runs else 0.0
    return any(math.dist(ball, other) < more + (GUARDED if guards(field, other) else PRESSED)
               for other in others)


def guards(field, other) -> bool:
    """Whether an opponent is in its own box, as its goalie, who waits for the ball there."""
    return (other[1] > field.length - field.box_depth and
            abs(other[0] - 0.5 * field.width) < 0.5 * field.box_width)


def goal_point(field, ball, others) -> tuple:
    """The goal's middle; from near by the side of the mouth that those before it leave free."""
    middle, line = 0.5 * field.width, field.length
    keepers = [x for x, y in others
               if y > line - KEEPER_AT and abs(x - middle) < KEEPER_AT]
    if math.dist(ball, (middle, line)) > GOAL_NEAR or not keepers:
        return middle, line + BEYOND
    aside = ASIDE if sum(keepers) / len(keepers) < middle else -ASIDE
    return middle + aside, line + BEYOND


def near_ball(others, ball) -> list:
    """(cm, direction) from the ball of those who may be in its way; worked out once for all ways,
    as the robot can spend little."""
    reach = math.hypot(IN_WAY, BODY)
    return [(math.dist(ball, other), direction(ball, other)) for other in others
            if math.dist(ball, other) < reach]


def in_way(near, degrees) -> float:
    """How much stands on the way from the ball in a direction: 0, up to about 1 for each body."""
    total = 0.0
    for away, bearing in near:
        off = math.radians(bearing - degrees)
        if 0.0 < math.cos(off) * away < IN_WAY:
            total += max(0.0, 1.0 - abs(math.sin(off)) * away / BODY) * (1.2 - away / IN_WAY)
    return total


def leaves(field, ball, degrees) -> bool:
    """Whether the ball would go over a line on that way, but for into the goal."""
    angle = math.radians(degrees)
    if not EDGE < ball[0] + AHEAD * math.cos(angle) < field.width - EDGE:
        return True
    left, ahead = field.length - ball[1], math.sin(angle)
    if left > LINE or ahead <= 0.05:
        return False
    crossing = ball[0] + left / ahead * math.cos(angle)
    return abs(crossing - 0.5 * field.width) > 0.5 * field.goal_width - POST


def run_way(field, ball, others) -> float:
    """The direction on the field in which the ball shall go."""
    goal, near = direction(ball, goal_point(field, ball, others)), near_ball(others, ball)

    def cost(turn):
        out = OUT_COST if leaves(field, ball, goal + turn) else 0.0
        return abs(turn) + BODY_COST * in_way(near, goal + turn) + out

    return goal + min(TURNS, key=cost)
