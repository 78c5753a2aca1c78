# SPDX-License-Identifier: Apache-2.0
# Walks to a ball in the goal box or at its edge so that a clearing kick hits it (thesis 2006
# section 4.3.1): of all kicks and directions it takes the place that is reached soonest, inside the
# box, and from which the kick is worth most. Keeps the place, chosen anew every half second or when
# the ball rolls on. Fails in scrums, where the ball moves with whoever pushes it.
import math

import kelpie
from arbiter.skill import Skill
from lib import kick_table
from lib.geom import clamp, from_field, wrap
from lib.goalie_places import UP_FIELD, beyond_box, direction, middle, past_ball
from lib.tune_goalie import Attack, Body
from skills.ball.clear_ball import Clearance
from skills.walk.guard_goal import in_box

TURNS = (0.0, -20.0, 20.0, -45.0, 45.0, -70.0, 70.0)  # deg from the way to the ball
PACE, PACE_TURN = 26.0, 120.0  # cm/s, deg/s: what a place costs in time
ASTERN = 1.5        # s for a place beyond the ball: the way leads round it
WORTH = 1.2         # s that a clearance of worth 1 may take longer than one of worth 0
CHOSEN = 0.3        # s that the place of before may take longer


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


class AttackBall(Skill):
    NAME = 'attack_ball'

    def __init__(self):
        self.stand = None
        self.chosen_s = 0.0
        self.ball = (0.0, 0.0)

    def can(self, world) -> bool:
        """Whether there is a place to kick the ball from."""
        self.choose_stand(world)
        return self.stand is not None

    def choose_stand(self, world):
        ball = (world.ball.position.x, world.ball.position.y)
        rolled = math.hypot(ball[0] - self.ball[0], ball[1] - self.ball[1])
        if world.time_s - self.chosen_s < Attack.AGAIN and rolled < Attack.MOVED:
            return
        self.chosen_s, self.ball = world.time_s, ball
        ahead = direction((world.pose.position.x, world.pose.position.y), ball)
        stands = [Stand(ball, kick, ahead + turn) for kick in kick_table.kicks(False)
                  for turn in TURNS]
        costs = [(cost(world, ball, stand, self.stand), stand) for stand in stands
                 if possible(world, ball, stand)]
        best = min(costs, key=lambda pair: pair[0], default=(math.inf, None))
        self.stand = best[1] if best[0] < math.inf else None

    def step(self, world) -> kelpie.WalkRequest:
        """To the place, but not up to the ball before side and heading fit."""
        stand = self.stand
        ball = (world.ball.position.x, world.ball.position.y)
        turn = wrap(stand.heading - world.pose.heading_deg)
        x, y = from_field(world.pose, *stand.back(ball, 0.0))
        if abs(turn) > Attack.TURN_FIRST or abs(x) > Attack.SIDE_FIRST:
            back_y = from_field(world.pose, *stand.back(ball, Attack.STAND_OFF))[1]
            y = back_y if back_y > 0.0 else min(y, 0.0)
        pace = min(1.0, Attack.WALK / max(Attack.GAIN * math.hypot(x, y), 1e-6))
        rate = clamp(Attack.TURN_GAIN * turn, -Attack.TURN, Attack.TURN)
        return in_box(world, kelpie.WalkRequest(forward=pace * Attack.GAIN * y,
                                                left=-pace * Attack.GAIN * x, turn_deg=rate))

    def explain(self, trace) -> None:
        if self.stand is not None:
            trace.append((kelpie.LAYER_SKILL, self.NAME, 'walk',
                          'the ball shall go to {} deg, kicked from ({}, {})',
                          self.stand.direction, self.stand.x, self.stand.y))


def possible(world, ball, stand) -> bool:
    """Inside the box before and after the kick; between goal and ball, since who turns aside lets
    the ball past; and with landmarks in view."""
    outwards = direction(middle(world.field), ball)
    return (abs(wrap(stand.heading - outwards)) < Attack.FACING and
            abs(wrap(stand.heading - UP_FIELD)) < Attack.LANDMARKS and
            beyond_box(world.field, (stand.x, stand.y), Body.MARGIN) < 1.0 and
            beyond_box(world.field, stand.after()) == 0.0)


def cost(world, ball, stand, chosen) -> float:
    """Seconds until the kick, less what it is worth; infinite for one at the own goal."""
    clearance = Clearance(world, stand.kick, ball, stand.outcome, stand.heading)
    if not clearance.safe:
        return math.inf
    x, y = world.pose.position.x, world.pose.position.y
    away = math.hypot(stand.x - x, stand.y - y)
    turn = abs(wrap(stand.heading - world.pose.heading_deg))
    seconds = max(away / PACE, turn / PACE_TURN) - WORTH * clearance.worth
    if past_ball((x, y), (stand.x, stand.y), ball):
        seconds += ASTERN
    same = chosen is not None and chosen.kick == stand.kick and chosen.direction == stand.direction
    return seconds - (CHOSEN if same else 0.0)
