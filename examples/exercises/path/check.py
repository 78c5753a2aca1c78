# SPDX-License-Identifier: Apache-2.0
"""A walk from one end of the field to the other, past robots that stand about."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

BODY, STEP, HIT = 30.0, 5.0, 60.0  # cm: nearer than that is a collision; a step; what one costs


def walked(module, draw):
    """cm to the goal, and 60 more for each step into somebody."""
    robots = [(draw.uniform(60.0, 300.0), draw.uniform(100.0, 440.0)) for _ in range(6)]
    x, y, total = 180.0, 20.0, 0.0
    while not math.dist((x, y), (180.0, 520.0)) <= 10.0 and total < 3000.0:  # nan never arrives
        way = math.radians(module.way((x, y), (180.0, 520.0), robots))
        x, y = x + STEP * math.cos(way), y + STEP * math.sin(way)
        total += STEP
        total += HIT * any(math.dist((x, y), robot) < BODY for robot in robots)
    return total


module, draw = checked(__file__), random.Random(2)
report("mean way, cm", sum(walked(module, draw) for _ in range(200)) / 200)
