# SPDX-License-Identifier: Apache-2.0
"""Four robots, each with its own, wrong, view of all; one of them shall go to the ball."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

SPEED, TURN = 30.0, 100.0  # cm/s, deg/s


def seconds(robot, ball):
    """Until a robot (x, y, the deg where it looks) is at the ball."""
    off = math.degrees(math.atan2(ball[1] - robot[1], ball[0] - robot[0])) - robot[2]
    return math.dist(robot[:2], ball) / SPEED + abs((off + 180.0) % 360.0 - 180.0) / TURN


def seen(draw, robot):
    return (draw.gauss(robot[0], 10.0), draw.gauss(robot[1], 10.0), draw.gauss(robot[2], 8.0))


def cost(module, draw):
    """Seconds until the ball is reached; each that goes for nothing costs 2 s, nobody 10."""
    ball = draw.uniform(0.0, 360.0), draw.uniform(0.0, 540.0)
    robots = [(draw.uniform(0.0, 360.0), draw.uniform(0.0, 540.0), draw.uniform(-180.0, 180.0))
              for _ in range(4)]
    going = []
    told = [seconds(seen(draw, robot), ball) for robot in robots]
    for own in range(4):
        view = [seen(draw, robot) for robot in robots]
        if module.goes(own, view, ball, told):
            going.append(seconds(robots[own], ball))
    return min(going) + 2.0 * (len(going) - 1) if going else 10.0


module, draw = checked(__file__), random.Random(8)
report("cost, s", sum(cost(module, draw) for _ in range(2000)) / 2000)
