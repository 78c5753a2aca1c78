# SPDX-License-Identifier: Apache-2.0
# The goalie's way to find a lost ball (thesis 2006 section 4.3.1): the head jumps between fixed
# points, rests at each and goes round again: the beacon at the near left, the far left, the far
# right, the near right, then five points low from right to left. One round takes 2.2 s, a sweep of
# the whole range 4.8 s, and it localises on the way. The thesis has one low point, before the
# chest; balls beside the goalie went in unseen. Keeps when it began and with which point. With a
# wrong pose it misses the beacons; a beacon that the pose says is out of reach is replaced by where
# it is seen from the middle.
import math

import kelpie
from arbiter.skill import Skill
from lib import rulebook
from lib.geom import from_field, heading
from lib.head import MAX_PAN, look_at, view
from lib.landmarks import GOALS


class Looks:
    """How long and how deep it looks at each point."""
    BEACON = 0.22            # s; the head pans 33 deg in 0.1 s, then three images
    LOW = 0.26               # 44 deg
    NEAR_TIMES = 0.24, 0.5, 0.9, 1.65, 3.15  # s, ends of the looks; in the last two the body turns
    DOWN = 12.0              # deg below the horizontal at the beacons: a ball from 30 cm on shows
    LOW_AT = 28.0            # cm; a ball from 12 to 130 cm shows
    NEAR = 60.0              # cm; a ball lost nearer is first looked for low

FROM_MIDDLE = (60.0, 27.0, -27.0, -60.0)  # deg, the beacons of 2006 from the middle of the goal
LOW = (-88.0, -44.0, 0.0, 44.0, 88.0)     # deg, the points after them
# Once before them, for a ball lost close by on the left: pan, and whereto the body turns.
NEAR = ((0.0, 0.0), (44.0, 0.0), (-44.0, 0.0), (44.0, 1.0), (-44.0, -1.0))


def beacons(field):
    """(x, y) of the four beacons: near left, far left, far right, near right of who looks
    up-field."""
    places = [(mark.position.x, mark.position.y) for mark in field.landmarks
              if mark.kind not in GOALS]
    left = sorted((p for p in places if p[0] < 0.5 * field.width), key=lambda p: p[1])
    right = sorted((p for p in places if p[0] > 0.5 * field.width), key=lambda p: -p[1])
    return left + right


class PointScan(Skill):
    NAME = 'point_scan'

    def __init__(self, world, near=0.0):
        """`near`: the side (+1 left, -1 right) where the ball was lost close by: before the first
        round the head looks low ahead, then the body turns to that side and to the other. 0: it
        was lost farther away."""
        self.start_s = world.time_s
        self.beacons = beacons(world.field)
        ours = rulebook.of(world).LOOKS_LOW
        self.lows = LOW if ours else (0.0,)
        self.near = tuple((near * pan, near * turn) for pan, turn in NEAR) if near and ours else ()
        self.branch, self.at = 'beacon', 0   # the point looked at

    def period(self) -> float:
        """Seconds of one round."""
        return len(self.beacons) * Looks.BEACON + len(self.lows) * Looks.LOW

    def rounds(self, world) -> int:
        """That came to an end."""
        return max(0, int(self.passed(world) / self.period()))

    def passed(self, world) -> float:
        """Seconds since the first round began; negative before it."""
        return world.time_s - self.start_s - (Looks.NEAR_TIMES[-1] if self.near else 0.0)

    def searches_near(self, world) -> bool:
        """Whether it still looks where the ball was lost close by."""
        return self.passed(world) < 0.0

    def step(self, world) -> kelpie.HeadRequest:
        passed = self.passed(world)
        if self.searches_near(world):
            self.branch = 'near'
            passed += Looks.NEAR_TIMES[-1]
            self.at = sum(passed >= end for end in Looks.NEAR_TIMES)
            return self.low(world, self.near[self.at][0])
        passed = math.fmod(passed, self.period())
        self.branch, self.at = 'beacon', int(passed / Looks.BEACON)
        if self.at < len(self.beacons):
            off_deg = heading(*from_field(world.pose, *self.beacons[self.at]))
            pan = off_deg if abs(off_deg) < MAX_PAN else FROM_MIDDLE[self.at]
            return view(pan, Looks.DOWN, world.stance)
        low = int((passed - len(self.beacons) * Looks.BEACON) / Looks.LOW)
        self.branch, self.at = 'low', min(low, len(self.lows) - 1)
        return self.low(world, self.lows[self.at])

    def turn_side(self, world) -> float:
        """Where the body must turn, +1 left: a head panned to the side cannot look down. 0: not."""
        return self.near[self.at][1] if self.branch == 'near' else 0.0

    def low(self, world, pan):
        angle = math.radians(pan)
        return look_at(-Looks.LOW_AT * math.sin(angle), Looks.LOW_AT * math.cos(angle), 0.0,
                       world.stance)

    def explain(self, trace) -> None:
        trace.append((kelpie.LAYER_SKILL, self.NAME, self.branch, 'point {}', self.at + 1))
