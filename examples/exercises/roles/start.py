# SPDX-License-Identifier: Apache-2.0
import math


def goes(own, robots, ball, told):
    """Whether robot number `own` (0 to 3) goes to the ball. It believes that the robots are at
    (x, y, deg where they look), and each of them has told how many s it needs, by its own wrong
    view of itself. They walk at 30 cm/s and turn at 100 deg/s first."""
    return math.dist(robots[own][:2], ball) < 150.0
