# SPDX-License-Identifier: Apache-2.0
import math


def look(time_s):
    """(deg to the left, deg up) where the head shall look so many seconds after the search began.
    It pans by at most 90 deg to either side, at 120 deg/s, and tilts at 90 deg/s."""
    return 90.0 * math.sin(0.5 * time_s), 0.0
