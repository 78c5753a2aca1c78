# SPDX-License-Identifier: Apache-2.0
# Whether a ball that is run at is better shot: the kick of a free ball that is likely enough to be
# a goal, for how the robot comes to it, through what opponents leave free of the mouth. Keeps
# nothing; what a kick does it reads from the kick map. Fails for a ball that somebody reaches
# before the kick, and against a goalie that is not where it was seen.
import math

import kelpie
from lib import kick_table
from lib.geom import wrap
from lib.goalie_places import direction
from lib.paths import point_of

CONSTANTS = kelpie.constants.run  # behaviour/constants.toml: defaults and ranges
SHOT = CONSTANTS.shot  # chance of a goal from which on a kick is better than running on,
KEEPS = 0.1          # and so much less for the kick that is played
NEAR = 70.0          # cm to the ball; farther, much will have changed until it is kicked
FAR = 230.0          # cm to the goal; no kick rolls farther
CLEAR = 45.0         # cm from the ball to an opponent: a nearer one has it before it is kicked
REACH = 20.0         # cm to each side that an opponent stops the ball: its body, and a step
AT_LEAST = 25.0      # cm; who is nearer than that to the ball covers no more for it
AIM_SD = 5.0         # deg beside the map's: the ball's place is off by 1 or 2 cm
KICKS = tuple(kick for kick in kick_table.kicks(False) if kelpie.KICKS[kick].leaf)


def open_shot(world, others, played=None) -> tuple | None:
    """(kick, chance of a goal) of the best kick, or None. `others`: where opponents are; `played`:
    the kick that is played."""
    ball, field, place = world.ball, world.field, point_of(world.ball)
    if not ball.present or ball.distance > NEAR:
        return None
    if math.dist(place, (0.5 * field.width, field.length)) > FAR:
        return None
    if any(math.dist(place, other) < CLEAR for other in others):
        return None
    shadows = [shadow(world, place, other) for other in others]
    chance, kick = max((chance_of(world, kick, place, shadows) +
                        (KEEPS if kick == played else 0.0), kick) for kick in KICKS)
    return (kick, chance) if chance > SHOT else None


def chance_of(world, kick, place, shadows) -> float:
    """Of a robot that looks at the ball as it kicks."""
    chance, way, *spread = kick_table.window_outcome(kick)
    outcome = chance, way + world.ball.heading_deg, *spread
    return kick_table.chance_of_goal(world.pose, place, outcome, world.field, blocked=shadows,
                                     heading_sd=math.hypot(world.heading_sd_deg, AIM_SD))


def shadow(world, ball, other) -> tuple:
    """The directions (low, high), in deg of the robot frame, in which an opponent stops a ball."""
    away = max(math.dist(ball, other), AT_LEAST)
    middle = wrap(direction(ball, other) - world.pose.heading_deg)
    half = math.degrees(math.atan2(REACH, away))
    return middle - half, middle + half
