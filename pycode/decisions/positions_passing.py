# SPDX-License-Identifier: Apache-2.0
# Places that value a pass and cover the own goal (world.task.passing; ours): about the place of the
# tree the one where the ball can be played to and from where the goal is open; a defender stands on
# the line from ball to own goal. Plain functions of a world; the caller keeps the place. It knows
# only those opponents that were seen in the last seconds.
import math

import kelpie
from decisions.passing import MARKED, SEEN_S, clear
from lib.geom import clamp
from lib.paths import goal_of
from situation import opponents
from situation.keep_off import inside

STEPS = ((0.0, 0.0), (70.0, 0.0), (-70.0, 0.0), (0.0, 60.0), (0.0, -60.0), (50.0, 50.0),
         (-50.0, 50.0))        # cm; the first is the tree's own place
FARTHEST = 80.0                # cm from the tree's place
PASS_FREE = 90.0  # cm that one goes for a free pass,
SHOT_FREE = 30.0  # cm for a free shot from there,
UNMARKED = 40.0   # cm to be unmarked
KICK = 165.0                   # cm; held kicks go 125 to 205 (docs/physical-body.md)
PER_CM = 0.3                   # that a cm off that distance counts
STAYS = 20.0                   # cm, bonus of the place of before


def moved(world, role, place, ball, before):
    """The place for a role whose tree says `place`; `before`: the last answer, or None."""
    if role == kelpie.DEFENDER:
        return covering(world.field, place, ball)
    choices = [inside(world.field, (place[0] + dx, place[1] + dy)) for dx, dy in STEPS]
    if before is not None and apart(before, place) < FARTHEST:
        choices.append(before)
    return max(choices, key=lambda one: utility(world, one, place, ball) +
               (STAYS if one == before else 0.0))


def utility(world, one, place, ball) -> float:
    total = -apart(one, place) - PER_CM * abs(apart(one, ball) - KICK)
    if not opponents.within(world, one, MARKED, SEEN_S):
        total += UNMARKED
    if clear(world, ball, one):
        total += PASS_FREE
    return total + (SHOT_FREE if clear(world, one, goal_of(world.field)) else 0.0)


def covering(field, place, ball):
    """At the tree's depth on the line from the ball to the middle of the own goal."""
    if ball[1] <= place[1] + 10.0:
        return place
    x = 0.5 * field.width
    x += (ball[0] - x) * clamp(place[1] / ball[1], 0.0, 1.0)
    return inside(field, (x, place[1]))


def apart(one, two) -> float:
    return math.hypot(one[0] - two[0], one[1] - two[1])
