# SPDX-License-Identifier: Apache-2.0
"""Kicks of a ball that lies before their goal or beside it; each goes astray a little."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

KICKS = {"hard": (251.0, 0.0, 10.0), "push": (140.0, 0.0, 5.0), "head_left": (198.0, 60.0, 12.0),
         "head_right": (198.0, -60.0, 12.0)}  # cm, deg to the left, standard deviation of that
X, Y, POST = 180.0, 540.0, 36.0               # cm: the goal's middle, and its half width


def goal(draw, x, y, looks, kick):
    distance, side, spread = KICKS[kick]
    way = math.radians(looks + side + draw.gauss(0.0, spread))
    far = distance * draw.gauss(1.0, 0.15)
    left = Y - y
    if math.sin(way) * far < left:
        return False
    return abs(x + left / math.tan(way) - X) < POST


def share(module, draw, count=3000):
    scored = 0
    for _ in range(count):
        x, y = draw.uniform(40.0, 320.0), draw.uniform(330.0, 510.0)
        looks = draw.uniform(0.0, 180.0)
        scored += goal(draw, x, y, looks, module.choose(x, y, looks))
    return scored / count


report("goals in a hundred kicks", 100.0 * share(checked(__file__), random.Random(4)))
