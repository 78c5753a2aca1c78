# SPDX-License-Identifier: Apache-2.0
import math


def place_of(pixel, height, tilt_deg):
    below = height - 4.2
    down = math.atan2(pixel[1] - 80.0, 192.0) - math.radians(tilt_deg)
    ahead = below / math.tan(max(down, 0.02))
    tilt = math.radians(tilt_deg)
    depth = ahead * math.cos(tilt) - below * math.sin(tilt)
    return (pixel[0] - 104.0) * depth / 192.0, ahead
