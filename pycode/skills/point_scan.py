# SPDX-License-Identifier: Apache-2.0
# The goalie's way to find a lost ball (thesis 2006 section 4.3.1): the head jumps between fixed
# points, rests at each and goes round again: the beacon at the near left, the far left, the far
# right, the near right, close before the chest. One round takes 1.3 s, a sweep of the whole range
# 4.8 s, and it localises on the way. Keeps when it began. With a wrong pose it misses the beacons;
# a beacon that the pose says is out of reach is replaced by where it is seen from the middle.
import math

import kelpie
from lib.geom import from_field, heading
from lib.head import MAX_PAN, look_at, view
from lib.landmarks import GOALS
from lib.tune_goalie import PointScan as Tune

FROM_MIDDLE = (60.0, 27.0, -27.0, -60.0)  # deg, the beacons of 2006 from the middle of the goal


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

    def __init__(self, world):
        self.start_s = world.time_s
        self.points = beacons(world.field)
        self.at = 0   # the point looked at

    def period(self) -> float:
        """Seconds of one round."""
        return len(self.points) * Tune.BEACON + Tune.FRONT

    def rounds(self, world) -> int:
        """That came to an end."""
        return int((world.time_s - self.start_s) / self.period())

    def head(self, world) -> kelpie.HeadRequest:
        passed = math.fmod(world.time_s - self.start_s, self.period())
        self.at = min(int(passed / Tune.BEACON), len(self.points))
        if self.at == len(self.points):
            return look_at(0.0, Tune.FRONT_AT, 0.0, world.stance)
        aside = heading(*from_field(world.pose, *self.points[self.at]))
        pan = aside if abs(aside) < MAX_PAN else FROM_MIDDLE[self.at]
        return view(pan, Tune.DOWN, world.stance)

    def explain(self, trace) -> None:
        branch = 'front' if self.at == len(self.points) else 'beacon'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch, 'point {} of {} of a round',
                      self.at + 1, len(self.points) + 1))
