# SPDX-License-Identifier: Apache-2.0
# Which kick of a held ball, by the map of where kicks send the ball (lib/kick_map.py, learnt on
# physical bodies), in place of the rules of the thesis: the one that is most likely a goal through
# the free gap, and where none reaches, the one that brings the ball nearest. It kicks while turning
# as soon as that is nearly as good as the aimed kick. Keeps nothing. As wrong as the pose, and as
# the map where a robot's kicks differ from it.
import math

import kelpie
from lib import kick_table
from lib.aim import mouth, size
from lib.geom import wrap

NEARLY = 0.93          # of the aimed kick's worth: turning on costs time
STILL = 35.0           # deg/s; who turns faster does not know where the kick goes
NEARNESS = 0.5         # worth of a ball on the goal line's middle, against a goal's 1
FALL_OFF = 150.0       # cm from the goal in which that falls to 1/e
OUT = 0.3              # share of that worth which a ball out of the field keeps
HELD = (kelpie.HARD_FORWARD, kelpie.WEDGE, kelpie.UPENN_LEFT, kelpie.UPENN_RIGHT,
        kelpie.HEAD_SWIPE_LEFT, kelpie.HEAD_SWIPE_RIGHT)


def choose(world, dribble, overdue) -> tuple | None:
    """As decisions/held_choice.py asks: (kick, reason, numbers...) or None."""
    gap = dribble.aim.gap or mouth(world)
    if gap is None and not overdue:
        return None
    kick, worth = best(world, gap, 0.0)
    turn = wrap(0.5 * (gap[0] + gap[1])) if gap is not None else 0.0
    aimed = best(world, gap, turn)[1]
    if overdue:
        return kick, 'out of time; worth {} of {} aimed', worth, aimed
    rate = abs(world.odometry.turn_deg) / max(world.elapsed_s, 0.02)
    if worth < NEARLY * aimed or rate > STILL or dribble.should_carry(world):
        return None
    return kick, 'chance {} now, {} aimed; gap {} deg', worth, aimed, size(gap)


def best(world, gap, turn) -> tuple:
    """(kick, its worth) for a robot that had turned by so many deg on the spot."""
    ranked = [(worth_of(world, kick, gap, turn), -kick) for kick in HELD
              if kick_table.holds(kick)]
    worth, kick = max(ranked)
    return -kick, worth


def worth_of(world, kick, gap, turn) -> float:
    outcome = kick_table.held_outcome(kick)
    place, field = world.pose.position, world.field
    way = world.pose.heading_deg + turn
    turned = None if gap is None else (gap[0] - turn, gap[1] - turn)
    goal = kick_table.chance_of_goal(world, way, turned, outcome)
    angle = math.radians(way + outcome.direction)
    x = place.x + outcome.distance * math.cos(angle)
    y = place.y + outcome.distance * math.sin(angle)
    inside = 0.0 < x < field.width and 0.0 < y < field.length
    left = math.hypot(x - 0.5 * field.width, min(y, field.length) - field.length)
    near = NEARNESS * math.exp(-left / FALL_OFF) * (1.0 if inside else OUT)
    return goal + (1.0 - goal) * outcome.chance * near
