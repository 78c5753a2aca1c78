# SPDX-License-Identifier: Apache-2.0
"""A robot sees two beacons; their places on the field are known."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

BEACONS = ((375.0, 135.0), (375.0, 405.0))  # cm


def sightings(seed, count=500):
    """True x, y, deg where it looks, and (cm away, deg to the left) of each beacon."""
    draw = random.Random(seed)
    for _ in range(count):
        x, y = draw.uniform(40.0, 300.0), draw.uniform(60.0, 480.0)
        looks = draw.uniform(-60.0, 60.0)
        seen = []
        for bx, by in BEACONS:
            away = math.dist((x, y), (bx, by))
            side = math.degrees(math.atan2(by - y, bx - x)) - looks
            seen.append((away * draw.gauss(1.0, 0.10), draw.gauss(side, 1.0)))
        yield (x, y), seen


module = checked(__file__)
errors = [math.dist(module.pose_of(seen, BEACONS)[:2], place) for place, seen in sightings(12)]
report("mean error of the place, cm", sum(errors) / len(errors))
