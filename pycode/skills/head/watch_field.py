# SPDX-License-Identifier: Apache-2.0
# Active localisation (thesis 2004 section 4.1.6): the head looks at corners and crossings of lines
# that are within its reach, from one to the next, and in between at the walls, where pinks hang.
# Keeps the target of this look and when it ends, from the pose; a wrong pose makes it look at
# nothing of use.
import kelpie
from arbiter.skill import Skill
from lib import features, rulebook
from lib.geom import Point, from_field, heading
from lib.head import look_at, view
from skills.walk.look_round import Look


class Features:
    """What the challenger's head looks at, of the field's features (lib/features.py)."""
    REACH = 80.0             # to either side
    NEAREST = 15.0           # cm
    FARTHEST = 200.0         # cm
    WALL_PAN = 40.0  # deg

BEST = 3        # so many of the features are looked at in turn
WALL_EVERY = 3  # every third look is at the wall, to the left and to the right in turn


class WatchField(Skill):
    NAME = 'watch_field'

    def __init__(self):
        self.next_s = 0.0
        self.looks = 0
        self.target = None  # a point of the field, or None: the wall
        self.places = None  # primary and secondary features, from the first frame on

    def step(self, world) -> kelpie.HeadRequest:
        if world.time_s >= self.next_s:
            self.next_s = world.time_s + rulebook.of(world).FEATURE_S
            self.looks += 1
            self.target = self.next_target(world)
        if self.target is None:
            side = 1.0 if self.looks % (2 * WALL_EVERY) == 0 else -1.0
            return view(side * Features.WALL_PAN, Look.DOWN[0], world.stance)
        return look_at(*from_field(world.pose, *self.target), 0.0, world.stance)

    def explain(self, trace) -> None:
        trace.append((self.LAYER, self.NAME, 'wall', 'look {}', self.looks) if self.target is None
                     else (self.LAYER, self.NAME, 'feature', 'at ({}, {})', *self.target))

    def next_target(self, world) -> Point | None:
        if self.looks % WALL_EVERY == 0:
            return None
        if self.places is None:
            self.places = features.primary(world.field), features.secondary(world.field)
        seen, at = in_reach(world.pose, *self.places), self.looks
        if rulebook.of(world).ALL_FEATURES:
            at -= self.looks // WALL_EVERY
        else:
            seen = seen[:BEST]
        return seen[at % len(seen)] if seen else None


def in_reach(pose, primary, secondary) -> list[Point]:
    """Features within 80 deg and 15 to 200 cm; corners and crossings first, the nearest of each."""
    def rank(kind, point):
        x, y = from_field(pose, *point)
        away = (x * x + y * y) ** 0.5
        good = abs(heading(x, y)) < Features.REACH and Features.NEAREST < away < Features.FARTHEST
        return (kind, away, point) if good else None
    ranked = [rank(0, p) for p in primary] + [rank(1, p) for p in secondary]
    best = sorted(r for r in ranked if r is not None)
    return [point for _, _, point in best]
