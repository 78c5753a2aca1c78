# SPDX-License-Identifier: Apache-2.0
import math


def way(here, goal, robots):
    """The direction of the next 5 cm from `here` to `goal`, in deg from +x to the left, so that 90
    is up the field. `robots` stand at (x, y); nearer than 30 cm to one is a collision."""
    return math.degrees(math.atan2(goal[1] - here[1], goal[0] - here[0]))
