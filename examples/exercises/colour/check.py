# SPDX-License-Identifier: Apache-2.0
"""Pixels of an image that is darker towards its corners, with their true classes."""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

MIDDLE = {"ball": (130, 190, 90), "carpet": (95, 105, 115), "line": (200, 122, 134),
          "yellow": (160, 150, 60)}  # Y, Cr, Cb
SPREAD = {"ball": (25, 12, 8), "carpet": (18, 6, 6), "line": (22, 6, 6), "yellow": (22, 10, 10)}


def pixels(seed, count=4000):
    draw = random.Random(seed)
    for _ in range(count):
        name = draw.choice(sorted(MIDDLE))
        x, y = draw.uniform(-104.0, 104.0), draw.uniform(-80.0, 80.0)
        dark = 1.0 - 0.45 * (x * x + y * y) / (104.0 ** 2 + 80.0 ** 2)
        colour = [draw.gauss(m, s) for m, s in zip(MIDDLE[name], SPREAD[name])]
        colour[0] *= dark
        colour[2] += 18.0 * (1.0 - dark) / 0.45
        yield name, colour, (x, y)


module = checked(__file__)
wrong = sum(module.classify(colour, place) != name for name, colour, place in pixels(7))
report("per cent of pixels in a wrong class", 100.0 * wrong / 4000)
