# SPDX-License-Identifier: Apache-2.0
# The goalie's way to find a lost ball (thesis 2006 section 4.3.1): the head jumps between fixed
# points, rests at each and goes round again: the beacon at the near left, the far left, the far
# right, the near right, then five points low from right to left. One round takes 2.2 s, a sweep of the whole range 4.8 s, and it localises on the way. The thesis has one
# low point, before the chest; balls beside the goalie went in unseen. Keeps when it began and with
# which point. With a wrong pose it misses the beacons; a beacon that the pose says is out of reach
# is replaced by where it is seen from the middle.
import math

import kelpie
from lib.geom import from_field, heading
from lib.head import MAX_PAN, look_at, view
from lib.landmarks import GOALS
from lib.tune_goalie import PointScan as Tune

FROM_MIDDLE = (60.0, 27.0, -27.0, -60.0)  # deg, the beacons of 2006 from the middle of the goal
LOW = (-88.0, -44.0, 0.0, 44.0, 88.0)     # deg, the points after them


def beacons(field):
    """(x, y) of the four beacons: near left, far left, far right, near right of who looks
    up-field."""
    places = [(mark.position.x, mark.position.y) for mark in field.landmarks
              if mark.kind not in GOALS]
    left = sorted((p for p in places if p[0] < 0.5 * field.width), key=lambda p: p[1])
    right = sorted((p for p in places if p[0] > 0.5 * field.width), key=lambda p: -p[1])
    return left + right


class PointScan:
    NAME = 'point_scan'

    def __init__(self, world, near_deg=None):
        """`near_deg`: where (deg to the left) the ball was lost, if that was close by: the low
        points there come first."""
        self.start_s = world.time_s
        self.beacons = beacons(world.field)
        self.times = (Tune.BEACON,) * len(self.beacons) + (Tune.LOW,) * len(LOW)
        self.first = 0
        if near_deg is not None:
            nearest = min(range(len(LOW)), key=lambda i: abs(LOW[i] - near_deg))
            self.first = len(self.beacons) + nearest
        self.at = self.first   # the point looked at

    def period(self) -> float:
        """Seconds of one round."""
        return sum(self.times)

    def rounds(self, world) -> int:
        """That came to an end."""
        return int((world.time_s - self.start_s) / self.period())

    def head(self, world) -> kelpie.HeadRequest:
        self.at = self.point(world.time_s - self.start_s)
        low = self.at - len(self.beacons)
        if low >= 0:
            aside = math.radians(LOW[low])
            return look_at(-Tune.LOW_AT * math.sin(aside), Tune.LOW_AT * math.cos(aside), 0.0,
                           world.stance)
        aside = heading(*from_field(world.pose, *self.beacons[self.at]))
        pan = aside if abs(aside) < MAX_PAN else FROM_MIDDLE[self.at]
        return view(pan, Tune.DOWN, world.stance)

    def point(self, passed) -> int:
        """The one that is looked at so many seconds after the scan's beginning."""
        passed = math.fmod(passed + sum(self.times[:self.first]), self.period())
        at = 0
        while at < len(self.times) - 1 and passed >= self.times[at]:
            passed -= self.times[at]
            at += 1
        return at

    def explain(self, trace) -> None:
        branch = 'low' if self.at >= len(self.beacons) else 'beacon'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch, 'point {} of {} of a round',
                      self.at + 1, len(self.times)))
