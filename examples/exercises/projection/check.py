# SPDX-License-Identifier: Apache-2.0
"""A ball on the carpet, and the pixel of the image in which its middle is seen."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

FOCAL, RADIUS = 192.0, 4.2  # pixels; cm


def views(seed, count=500):
    """Place of the ball (cm to the right, cm ahead), its pixel, height and tilt of the camera."""
    draw = random.Random(seed)
    while count:
        height, tilt = draw.uniform(16.0, 22.0), math.radians(draw.uniform(-40.0, -5.0))
        right, ahead = draw.uniform(-60.0, 60.0), draw.uniform(20.0, 150.0)
        below = height - RADIUS
        depth = ahead * math.cos(tilt) - below * math.sin(tilt)
        down = ahead * math.sin(tilt) + below * math.cos(tilt)
        x, y = 104.0 + FOCAL * right / depth, 80.0 + FOCAL * down / depth
        if 0.0 < x < 208.0 and 0.0 < y < 160.0:
            count -= 1
            pixel = draw.gauss(x, 0.5), draw.gauss(y, 0.5)
            yield (right, ahead), pixel, height, math.degrees(tilt)


module = checked(__file__)
errors = sorted(math.dist(module.place_of(pixel, height, tilt), place)
                for place, pixel, height, tilt in views(3))
report("median error, cm", errors[len(errors) // 2])
