# SPDX-License-Identifier: Apache-2.0
"""A ball lies somewhere before the robot, and the head looks for it."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

PAN_SPEED, TILT_SPEED, FRAME_S = 120.0, 90.0, 1.0 / 30.0  # deg/s; s
HALF_WIDTH, HALF_HEIGHT, LONGEST = 28.0, 22.0, 300        # deg; frames


def towards(now, wanted, speed):
    return now + max(-speed * FRAME_S, min(speed * FRAME_S, wanted - now))


def seconds(module, draw):
    away, side = 15.0 + 285.0 * draw.random() ** 2, draw.uniform(-110.0, 110.0)
    up, pan, tilt = -math.degrees(math.atan2(16.0, away)), 0.0, 0.0
    for frame in range(LONGEST):
        if abs(side - pan) < HALF_WIDTH and abs(up - tilt) < HALF_HEIGHT:
            return frame * FRAME_S
        wanted = module.look(frame * FRAME_S)
        pan = max(-90.0, min(90.0, towards(pan, wanted[0], PAN_SPEED)))
        tilt = max(-70.0, min(30.0, towards(tilt, wanted[1], TILT_SPEED)))
    return LONGEST * FRAME_S


module, draw = checked(__file__), random.Random(9)
report("mean time, s", sum(seconds(module, draw) for _ in range(300)) / 300)
