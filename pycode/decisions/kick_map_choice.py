# SPDX-License-Identifier: Apache-2.0
# Which kick of a held ball, by the map of where kicks send the ball (data/kick_map.py, learnt on
# physical bodies), in place of the rules of the thesis: the one that is most likely a goal through
# the free gap, and where none reaches, the one that brings the ball nearest. It kicks while turning
# as soon as that is nearly as good as the aimed kick. Out of time it takes the best of all kicks,
# or lets the ball go. Keeps nothing. As wrong as the pose, and as the map where a robot's kicks
# differ from it.
import math

import kelpie
from decisions.kick_choice import RELEASE
from lib import kick_table
from lib.geom import wrap
from situation.aim import mouth, size
from situation.infrared import somebody_near

CONSTANTS = kelpie.constants.kick_map  # behaviour/constants.toml: defaults and ranges
NEARLY = CONSTANTS.nearly  # of the aimed kick's utility: turning on costs time
STILL_GOOD = CONSTANTS.still_good  # of it for who has stopped for the kick: gaps are unsteady
GOOD = 0.7             # utility of a kick that is done wherever a carry would go on: a kick of
                       # 2.4 m in time is worth more than 25 cm nearer
AIM_SD = 7.0           # deg beside the map's: of 40 kicks from matches 7.5, the map 1.0
NEARNESS = CONSTANTS.nearness  # utility of a ball in the goal line's middle, if a goal is 1; it
                       # falls to 0
FALL_OFF = 650.0       # cm away, about the field's diagonal
OUT = CONSTANTS.out  # share of that utility which a ball out of the field keeps
OWN_END = 45.0         # cm from the own goal line: a ball that goes there has a utility
OWN_END_UTILITY = -0.5  # of so much, since it may be an own goal
LET_GO = CONSTANTS.let_go  # share of its place's utility that a ball let go keeps
FREED = CONSTANTS.freed  # share of the kicks that move the ball farther than 30 cm with
                       # somebody under the nose: 11 of 29 in two matches, of the others 59 of 76
BESIDE = 30.0          # deg
# Held kicks straight ahead, as far as the map knows.
AHEAD = tuple(kick for kick in kick_table.kicks(True) if kelpie.KICKS[kick].mirror == kick)
HELD_AHEAD = 8.0       # cm from the neck to a held ball


def choose(world, dribble, overdue) -> tuple | None:
    """As decisions/held_choice.py asks: (kick, reason, numbers...) or None."""
    gap = dribble.aim.gap or mouth(world)
    if overdue:
        return out_of_time(world, gap)
    if gap is None:
        return None
    middle = wrap(0.5 * (gap[0] + gap[1]))
    utility, kick = best(world, gap, middle)
    if utility <= 0.0:
        return None
    aimed = max(utility_of(world, one, gap, middle) for one in AHEAD)
    nearly = STILL_GOOD if dribble.standing else NEARLY
    if utility < nearly * aimed or (utility < GOOD and dribble.should_carry(world)):
        return None
    return kick, 'worth {}, {} aimed; gap of {} deg', utility, aimed, size(gap)


def out_of_time(world, gap) -> tuple:
    """Of all kicks, wherever the goal is. The ball is let go where each would make it worse: who
    was held up in its turn looks at the own goal."""
    utility, kick = max((utility_now(world, kick, gap), kick) for kick in kick_table.kicks(True))
    let_go = utility_let_go(world)
    if utility <= let_go:
        return RELEASE, 'out of time; worth {}, let go {}', utility, let_go
    return kick, 'out of time; worth {}, let go {}', utility, let_go


def best(world, gap, middle) -> tuple:
    """(utility, kick) for how the robot stands; kicks that send the ball far beside the gap's
    middle have none, which spares the robot their sums."""
    utilities = [(0.0, kelpie.HARD_FORWARD)]
    for kick in kick_table.kicks(True):
        direction = kick_table.held_outcome(kick)[1]
        if abs(wrap(direction - middle)) < BESIDE:
            utilities.append((utility_now(world, kick, gap), kick))
    return max(utilities)


def utility_now(world, kick, gap):
    """Of a kick from the hold as the robot stands: one ahead leaves the ball lying more often than
    not while somebody is under the nose."""
    utility = utility_of(world, kick, gap, 0.0)
    if kick not in AHEAD or not somebody_near(world):
        return utility
    return FREED * utility + (1.0 - FREED) * utility_let_go(world)


def utility_let_go(world):
    return LET_GO * nearness(world.field, *held_ball(world))


def utility_of(world, kick, gap, turn) -> float:
    """Of a kick from the hold, once the robot has turned by so many deg."""
    return utility_of_way(world, held_ball(world), world.pose.heading_deg + turn,
                        kick_table.held_outcome(kick), gap)


def utility_of_way(world, ball, way, outcome, gap=None) -> float:
    """The chance of a goal, and of what is no goal how near the ball comes to it, for a kick with
    that outcome by a robot that looks along `way` (deg on the field); `gap` in deg of the robot's
    frame of now."""
    chance, direction, sd, distance, far_sd = outcome
    field = world.field
    turned = chance, direction + wrap(way - world.pose.heading_deg), sd, distance, far_sd
    free = None if gap is None else (gap[1], gap[0])
    goal = kick_table.chance_of_goal(world.pose, ball, turned, field, free,
                                     heading_sd=math.hypot(world.heading_sd_deg, AIM_SD))
    angle = math.radians(way + direction)
    x, y = ball[0] + distance * math.cos(angle), ball[1] + distance * math.sin(angle)
    return goal + (1.0 - goal) * chance * nearness(field, x, y)


def nearness(field, x, y) -> float:
    """The utility of a ball that lies there."""
    if y < OWN_END:
        return OWN_END_UTILITY
    inside = 0.0 < x < field.width and 0.0 < y < field.length
    left = math.hypot(x - 0.5 * field.width, min(y, field.length) - field.length)
    return NEARNESS * max(0.0, 1.0 - left / FALL_OFF) * (1.0 if inside else OUT)


def held_ball(world):
    """Where a held ball is on the field."""
    angle = math.radians(world.pose.heading_deg)
    place = world.pose.position
    return place.x + HELD_AHEAD * math.cos(angle), place.y + HELD_AHEAD * math.sin(angle)
