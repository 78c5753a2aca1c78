# SPDX-License-Identifier: Apache-2.0
# A deliberate pass of a held ball (world.task.passing; thesis 2006 section 8.2 names it as work to
# come): the kick of the map (data/kick_map.py) whose ball comes to rest at a mate that is better
# placed, on a way that no opponent is near. Keeps nothing. A mate is taken to stay where it says it
# is; what it believes of its own place adds to where the ball may be missed.
import kelpie

import math

from decisions.kick_map_choice import FALL_OFF, NEARNESS
from decisions.roles import forwards
from lib import kick_table
from lib.geom import clamp, wrap
from lib.paths import goal_of, point_of
from situation.keep_off import Lane

CONSTANTS = kelpie.constants.passing  # behaviour/constants.toml: defaults and ranges
REACH = 60.0         # cm from the mate to where the ball comes to rest: 2 s of walking
ON_WAY = 35.0        # cm from the ball's way: it is stopped by who stands there
BLOCKED = 25.0       # cm from an opponent to the ball's way: half a body and the ball
MARKED = 50.0        # cm from an opponent to a mate
SEEN_S = 2.0         # s; of opponents
SHOT_FROM = 230.0    # cm from which a ball reaches the goal (skills/ball/grab_dribble.py)
SHOT = 0.5           # utility of a shot at the goal from the line
LOST = 0.25          # share of a utility that is lost in taking the ball
MIN_GAIN = CONSTANTS.min_gain  # by which a pass must have more utility than the own kick


def utility_at(world, place) -> float:
    """The utility of a ball at the feet of a mate that stands there."""
    goal = goal_of(world.field)
    away = math.hypot(goal[0] - place[0], goal[1] - place[1])
    near = NEARNESS * max(0.0, 1.0 - away / FALL_OFF)
    free = clear(world, place, goal)
    shot = SHOT * clamp(1.0 - away / SHOT_FROM, 0.0, 1.0) if free else 0.0
    return (1.0 - LOST) * (near + shot)


def clear(world, start, end, width=BLOCKED) -> bool:
    """Whether no opponent is known near the way from one place to another."""
    lane = Lane('', start, end, width)
    return not any(lane.gap(point_of(one)) < width for one in world.opponents
                   if one.seconds_since_seen < SEEN_S)


def best(world, ball) -> tuple | None:
    """(utility, kick, player) of the best pass of a ball held at a place of the field, for how the
    robot stands; None when none arrives."""
    found = None
    mates = forwards(world)
    for kick in kick_table.kicks(True) if mates else ():
        chance, direction, _, distance, _ = kick_table.held_outcome(kick)
        angle = math.radians(wrap(world.pose.heading_deg + direction))
        end = ball[0] + distance * math.cos(angle), ball[1] + distance * math.sin(angle)
        way = Lane('', ball, end, BLOCKED)
        for mate in mates:
            place = point_of(mate.pose)
            if not arrives(way, place) or not clear(world, ball, place):
                continue
            utility = chance * utility_at(world, place)
            if found is None or utility > found[0]:
                found = utility, kick, mate.player
    return found


def arrives(way, place) -> bool:
    """Whether a mate there gets a ball on that way: it passes or rests near, and not at once."""
    if math.hypot(place[0] - way.start[0], place[1] - way.start[1]) < REACH:
        return False
    rests = math.hypot(place[0] - way.end[0], place[1] - way.end[1]) < REACH
    return rests or way.gap(place) < ON_WAY
