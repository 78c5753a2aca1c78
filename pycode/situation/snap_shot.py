# SPDX-License-Identifier: Apache-2.0
# A shot without a stop: the kick of a ball that is run with, as it lies when the motion strikes,
# that is likely enough to be a goal through what the opponents leave free of the mouth. Keeps
# nothing; what a kick does it reads from the kick map. Fails where the map does, for a ball that
# rolls otherwise than is believed, and against a goalie that is not where it was seen.
import math

from lib import kick_table
from lib.geom import wrap
from lib.goalie_places import direction
from lib.paths import point_of
from situation.clearance import in_window, strikes, walks
from situation.run_way import opponents

SHOT = 0.4           # chance of a goal from which on it is better to kick than to run
SEEN = 0.2           # s; of kicks at balls unseen for longer hardly one hit
NEAR = 25.0          # cm; no kick reaches farther
FAR = 230.0          # cm to the goal; no kick rolls farther
REACH = 20.0         # cm to each side that an opponent stops the ball: its body, and a step
AT_LEAST = 25.0      # cm; who is nearer than that to the ball covers no more for it
AIM_SD = 5.0         # deg beside the map's: the ball's place is off by 1 or 2 cm


def snap_shot(world) -> tuple | None:
    """(kick, chance of a goal) of the best one, or None."""
    ball, field = world.ball, world.field
    if not ball.present or ball.seconds_since_seen > SEEN or ball.distance > NEAR:
        return None
    if math.dist(point_of(ball), (0.5 * field.width, field.length)) > FAR:
        return None
    strikes_at, walking = strikes(world), walks(world)
    shadows = [shadow(world, point_of(ball), other) for other in opponents(world)]
    chance, kick = max((chance_of(world, kick, strikes_at, walking, shadows), kick)
                       for kick in kick_table.kicks(False))
    return (kick, chance) if chance > SHOT else None


def chance_of(world, kick, strikes_at, walking, shadows) -> float:
    """The least chance over the moments at which the motion may begin."""
    least = 1.0
    for place, ball in strikes_at:
        outcome = (kick_table.outcome(kick, *place, walking)
                   if in_window(kick, *place, walking) else None)
        if outcome is None:
            return 0.0
        spread = math.hypot(world.heading_sd_deg, AIM_SD)
        least = min(least, kick_table.chance_of_goal(world.pose, ball, outcome, world.field,
                                                     blocked=shadows, heading_sd=spread))
    return least


def shadow(world, ball, other) -> tuple:
    """The directions (low, high), in deg of the robot frame, in which an opponent stops a ball."""
    away = max(math.dist(ball, other), AT_LEAST)
    middle = wrap(direction(ball, other) - world.pose.heading_deg)
    half = math.degrees(math.atan2(REACH, away))
    return middle - half, middle + half
