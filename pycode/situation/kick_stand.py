# SPDX-License-Identifier: Apache-2.0
# The place from which a goalie can clear a ball in or at its box (thesis 2006 section 4.3.1): of
# all kicks and directions the one that is reached soonest, inside the box, and from which the kick
# has the highest utility. choose() keeps nothing; what it answers goes in again, since a place is
# kept for half a second unless the ball rolls on. Fails in scrums, where the ball moves with
# whoever pushes it.
import kelpie

import math

from lib import kick_table, rulebook
from lib.geom import wrap
from lib.goalie_places import MARGIN, UP_FIELD, beyond_box, direction, middle, past_ball
from lib.paths import point_of
from situation.clearance import Clearance, kicks

CONSTANTS = kelpie.constants.kick_stand  # behaviour/constants.toml: defaults and ranges
TURNS = (0.0, -20.0, 20.0, -45.0, 45.0, -70.0, 70.0)  # deg from the way to the ball
PACE = 26.0         # cm/s: what a place costs in time,
PACE_TURN = 120.0   # deg/s
ASTERN = CONSTANTS.astern  # s for a place beyond the ball: the way leads round it
UTILITY = CONSTANTS.utility  # s that a clearance of utility 1 may take longer than one of 0
CHOSEN = CONSTANTS.chosen  # s that the place of before may take longer
AGAIN = 0.5         # s after which the place is chosen anew,
MOVED = 6.0         # or cm that the ball has rolled
LANDMARKS = 75.0    # deg from up-field: three kicks at a ball in the corner, with no landmark in
                    # view, left a heading 30 deg wrong and the box far behind
FACING = 55.0       # deg from the way out of the goal past the ball, at most


class Stand:
    """Where to stand with that heading for a kick: a place on the field."""

    def __init__(self, ball, kick, heading_deg):
        self.kick, self.heading = kick, heading_deg
        self.right, self.far = kick_table.best_place(kick)
        self.outcome = kick_table.outcome(kick, self.right, self.far)
        self.direction = heading_deg + self.outcome[1]
        angle = math.radians(self.heading)
        self.ahead = (math.cos(angle), math.sin(angle))
        self.x, self.y = self.back(ball, 0.0)

    def back(self, ball, off):
        """The place from which the ball lies where the kick needs it, `off` cm farther ahead."""
        dx, dy = self.ahead
        far = self.far + off
        return ball[0] - far * dx - self.right * dy, ball[1] - far * dy + self.right * dx

    def after(self):
        """Where the kick leaves the robot."""
        right, ahead, _ = kick_table.turn_way(self.kick)
        dx, dy = self.ahead
        return self.x + ahead * dx + right * dy, self.y + ahead * dy - right * dx


class Choice:
    """A stand, or None, with when it was chosen and for which ball."""

    def __init__(self, stand=None, chosen_s=0.0, ball=(0.0, 0.0)):
        self.stand, self.chosen_s, self.ball = stand, chosen_s, ball


def choose(world, before=None) -> Choice:
    """The choice of this frame; `before`: that of the last one, None at the beginning."""
    before = before or Choice()
    ball = point_of(world.ball)
    rolled = math.hypot(ball[0] - before.ball[0], ball[1] - before.ball[1])
    if world.time_s - before.chosen_s < AGAIN and rolled < MOVED:
        return before
    ahead = direction(point_of(world.pose), ball)
    stands = [Stand(ball, kick, ahead + turn) for kick in kicks(world)
              for turn in TURNS]
    costs = [(cost(world, ball, stand, before.stand), stand) for stand in stands
             if possible(world, ball, stand)]
    best = min(costs, key=lambda pair: pair[0], default=(math.inf, None))
    return Choice(best[1] if best[0] < math.inf else None, world.time_s, ball)


def possible(world, ball, stand) -> bool:
    """Inside the box before and after the kick; between goal and ball, since who turns away lets
    the ball past; and with landmarks in view."""
    outwards = direction(middle(world.field), ball)
    return (abs(wrap(stand.heading - outwards)) < FACING and
            abs(wrap(stand.heading - UP_FIELD)) < LANDMARKS and
            beyond_box(world.field, (stand.x, stand.y), MARGIN) < 1.0 and
            beyond_box(world.field, stand.after()) == 0.0)


def cost(world, ball, stand, chosen) -> float:
    """Seconds until the kick, less its utility; infinite for one at the own goal."""
    clearance = Clearance(world, stand.kick, ball, stand.outcome, stand.heading)
    if not clearance.safe:
        return math.inf
    x, y = world.pose.position.x, world.pose.position.y
    away = math.hypot(stand.x - x, stand.y - y)
    turn = abs(wrap(stand.heading - world.pose.heading_deg))
    seconds = max(away / PACE, turn / PACE_TURN)
    if rulebook.of(world).CLEARS_BY_MAP:
        seconds -= UTILITY * clearance.utility
    if past_ball((x, y), (stand.x, stand.y), ball):
        seconds += ASTERN
    same = chosen is not None and chosen.kick == stand.kick and chosen.direction == stand.direction
    return seconds - (CHOSEN if same else 0.0)
