# SPDX-License-Identifier: Apache-2.0
import math


def place(ball):
    left, right = (math.atan2(ball[1], ball[0] - post) for post in (-40.0, 40.0))
    bisector = 0.5 * (left + right)
    y = 45.0
    x = ball[0] - (ball[1] - y) / math.tan(bisector)
    return max(-64.0, min(64.0, x)), y
