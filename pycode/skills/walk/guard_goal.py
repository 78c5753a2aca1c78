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
from lib.goalie_places import clip_to_box, kept_in_box
from lib.tune_goalie import Body, Guard


def in_box(world, walk, margin=Body.MARGIN) -> kelpie.WalkRequest:
    """The walk, slowed so that the neck base stays in the goal box, that margin (cm) inside."""
    forward, left = kept_in_box(world.field, world.pose, walk.forward, walk.left, margin,
                                Body.SECONDS)
    share = min(1.0, Body.SPEED / max(math.hypot(forward, left), 1e-6))
    return kelpie.WalkRequest(forward=share * forward, left=share * left, turn_deg=walk.turn_deg,
                              kind=walk.kind)


def walk_towards(world, place, gain=Guard.GAIN, speed=Body.SPEED) -> kelpie.WalkRequest:
    """Straight to a place of the field while turning to its heading."""
    x, y = from_field(world.pose, place[0], place[1])
    pace = min(1.0, speed / max(gain * math.hypot(x, y), 1e-6))
    turn = clamp(Guard.TURN_GAIN * wrap(place[2] - world.pose.heading_deg), -Body.TURN, Body.TURN)
    return kelpie.WalkRequest(forward=pace * gain * y, left=-pace * gain * x, turn_deg=turn)


class GuardGoal(Skill):
    NAME = 'guard_goal'

    def __init__(self, tune):
        self.tune = tune      # whose LAZY, ACCURATE, LAZY_TURN and ACCURATE_TURN hold
        self.moving = self.turning = False
        self.off = self.aside = 0.0

    def step(self, world, place) -> kelpie.WalkRequest:
        place = (*clip_to_box(world.field, place[:2], Body.MARGIN), place[2])
        self.judge(world, place)
        walk = walk_towards(world, place)
        if not self.turning:
            walk.turn_deg = 0.0
        if not self.moving:
            walk.forward = walk.left = 0.0
        return in_box(world, walk)

    def judge(self, world, place):
        self.off = math.hypot(*from_field(world.pose, place[0], place[1]))
        self.aside = wrap(place[2] - world.pose.heading_deg)
        tune = self.tune
        self.moving = self.off > (tune.ACCURATE if self.moving else tune.LAZY)
        self.turning = abs(self.aside) > (tune.ACCURATE_TURN if self.turning else tune.LAZY_TURN)

    def explain(self, trace) -> None:
        branch = 'move' if self.moving else 'turn' if self.turning else 'stand'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch,
                      'the place is {} cm away, its heading {} deg aside', self.off, self.aside))
