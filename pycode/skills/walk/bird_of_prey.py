# SPDX-License-Identifier: Apache-2.0
# Goes home on a curve round whoever stands on the way, without slowing down (Bird of Prey, thesis
# 2006 section 4.3.3, figure 4.6). Keeps the bend of the way, which lib/paths.py chooses five times
# a second from what is known of others. With world.task.bird_of_prey off it goes straight. Whoever
# walks into its way is seen late: paws (skills/walk/paw_stuck.py) are the last resort.
import math

import kelpie
from arbiter.skill import Skill
from lib import paths, rulebook
from lib.geom import from_field, heading, polar
from lib.steer import towards

EVERY_FRAMES = 6  # frames
FAST_FROM = 60.0     # cm; from there on the fast walk, ahead only
FAST_WITHIN = 20.0   # deg
FAST_UNTIL = 30.0  # deg
FAST_SPEED = 44.0    # cm/s


class BirdOfPrey(Skill):
    NAME = 'bird_of_prey'

    def __init__(self):
        self.bend = 0.0
        self.frames = 0    # until the way is chosen again
        self.away = 0.0

    def step(self, world, place) -> kelpie.WalkRequest:
        """To a place of the field."""
        x, y = from_field(world.pose, *place)
        self.away = math.hypot(x, y)
        self.choose_bend(world, place)
        # Near the end an arc is as good as straight; its bend would lead round the place.
        share = min(1.0, self.away / FAST_FROM)
        off_deg = heading(x, y) + share * self.bend
        speed = {}
        within = FAST_UNTIL if world.last_command.walk.kind == kelpie.WALK_FAST else FAST_WITHIN
        fast = self.away > FAST_FROM and abs(off_deg) < within
        if fast:
            speed = {'speed': FAST_SPEED}
        walk = towards(polar(self.away, off_deg), **speed)
        walk.kind = kelpie.WALK_FAST if fast else kelpie.WALK
        return walk

    def choose_bend(self, world, place):
        self.frames -= 1
        if self.frames > 0:
            return
        self.frames = EVERY_FRAMES
        if not rulebook.flies_home(world):
            self.bend = 0.0
            return
        here = paths.point_of(world.pose)
        self.bend = paths.best_bend(paths.others(world), here, place, world.field, self.bend)

    def explain(self, trace) -> None:
        branch = 'straight' if self.bend == 0.0 else 'left' if self.bend > 0.0 else 'right'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch, '{} cm to go, bent by {} deg',
                      self.away, self.bend))
