# SPDX-License-Identifier: Apache-2.0
# Goes to the place that a rule gives for the ball and keeps it, facing the ball: walking in any
# direction at once, since the way is short and the ball is to be kept in view. Begins to move when
# it is off by more than the laziness and stops within the accuracy, the smaller one (thesis 2004
# section 4.2.1): who stands still sees better. Keeps whether it moves and whether it turns. Never
# asks for a way out of the box; it is as wrong about the box as the pose.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import clamp, from_field, wrap
from lib.goalie_places import clip_to_box
from safety import own_box

GAIN = 2.5           # cm/s per cm
TURN_GAIN = 3.0      # deg/s per deg
TURN = 180.0         # deg/s; the walk does 214 (docs/physical-body.md)


class Laziness:
    """How far off the place (cm) and its heading (deg) it begins and stops to move and to turn."""

    def __init__(self, lazy, accurate, lazy_turn, accurate_turn):
        self.lazy, self.accurate = lazy, accurate
        self.lazy_turn, self.accurate_turn = lazy_turn, accurate_turn


OF_2006 = Laziness(8.0, 3.0, 14.0, 5.0)     # after facts-2005 7.2 and K10
OF_2004 = Laziness(15.0, 7.0, 20.0, 8.0)    # checklist U14
NONE = Laziness(2.0, 1.0, 30.0, 20.0)       # a ball comes: no turn where a side step will do


def walk_towards(world, place, gain=GAIN, speed=own_box.SPEED) -> kelpie.WalkRequest:
    """Straight to a place of the field while turning to its heading."""
    x, y = from_field(world.pose, place[0], place[1])
    pace = min(1.0, speed / max(gain * math.hypot(x, y), 1e-6))
    turn = clamp(TURN_GAIN * wrap(place[2] - world.pose.heading_deg), -TURN, TURN)
    return kelpie.WalkRequest(forward=pace * gain * y, left=-pace * gain * x, turn_deg=turn)


class GuardGoal(Skill):
    NAME = 'guard_goal'

    def __init__(self, laziness):
        self.laziness = laziness
        self.moving = self.turning = False
        self.off = self.off_deg = 0.0

    def step(self, world, place) -> kelpie.WalkRequest:
        place = (*clip_to_box(world.field, place[:2], own_box.MARGIN), place[2])
        self.judge(world, place)
        walk = walk_towards(world, place)
        if not self.turning:
            walk.turn_deg = 0.0
        if not self.moving:
            walk.forward = walk.left = 0.0
        return own_box.inside(world, walk)

    def judge(self, world, place):
        self.off = math.hypot(*from_field(world.pose, place[0], place[1]))
        self.off_deg = wrap(place[2] - world.pose.heading_deg)
        lazy = self.laziness
        self.moving = self.off > (lazy.accurate if self.moving else lazy.lazy)
        self.turning = abs(self.off_deg) > (lazy.accurate_turn if self.turning else lazy.lazy_turn)

    def explain(self, trace) -> None:
        branch = 'move' if self.moving else 'turn' if self.turning else 'stand'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch,
                      'the place is {} cm away, its heading {} deg aside', self.off, self.off_deg))
