# SPDX-License-Identifier: Apache-2.0
"""Shots from all over their half of the field at a goal that one robot keeps."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

REACH, HALF, SPEED = 14.0, 40.0, 180.0  # cm to a side at once; half of the goal; cm/s of the ball
WALK, DELAY = 15.0, 0.6                 # cm/s; s until it moves


def saved(place, ball, target):
    """Whether the ball passes the robot within its reach; it moves once the ball has begun to."""
    way = target - ball[0], -ball[1]
    length = math.hypot(*way)
    along = ((place[0] - ball[0]) * way[0] + (place[1] - ball[1]) * way[1]) / length
    off = abs((place[0] - ball[0]) * way[1] - (place[1] - ball[1]) * way[0]) / length
    return off < REACH + WALK * max(0.0, along / SPEED - DELAY)


def shots(draw, count=3000):
    for _ in range(count):
        yield (draw.uniform(-180.0, 180.0), draw.uniform(80.0, 300.0)), draw.uniform(-HALF, HALF)


module, held = checked(__file__), 0
for ball, target in shots(random.Random(6)):
    x, y = module.place(ball)
    # Who leaves the box, is at a post or too near to the ball may not, or cannot.
    held += (abs(x) < 65.0 and 8.0 <= y <= 50.0 and math.dist((x, y), ball) > 25.0 and
             saved((x, y), ball, target))
report("shots held, per cent", 100.0 * held / 3000)
