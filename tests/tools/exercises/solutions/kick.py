# SPDX-License-Identifier: Apache-2.0
import math

KICKS = {"hard": (251.0, 0.0, 10.0), "push": (140.0, 0.0, 5.0), "head_left": (198.0, 60.0, 12.0),
         "head_right": (198.0, -60.0, 12.0)}


def bell(x):
    return 0.5 * (1.0 + math.erf(x / math.sqrt(2.0)))


def chance(x, y, looks, kick):
    distance, side, spread = kick
    left, right = (math.degrees(math.atan2(540.0 - y, post - x)) for post in (144.0, 216.0))
    way = looks + side
    inside = bell((left - way) / spread) - bell((right - way) / spread)
    away = math.hypot(180.0 - x, 540.0 - y)
    return inside * bell((distance - away) / (0.15 * distance))


def choose(x, y, looks_deg):
    return max(KICKS, key=lambda name: chance(x, y, looks_deg, KICKS[name]))
