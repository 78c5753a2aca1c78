# SPDX-License-Identifier: Apache-2.0
import math

KEEP = 34.0


def free(here, way, far, robots):
    for x, y in robots:
        dx, dy = x - here[0], y - here[1]
        along = dx * math.cos(way) + dy * math.sin(way)
        across = abs(dx * math.sin(way) - dy * math.cos(way))
        away = math.hypot(dx, dy)
        if 0.0 < along < far and across < min(KEEP, max(away - 1.0, 0.0)):
            return False
    return True


def way(here, goal, robots):
    straight = math.atan2(goal[1] - here[1], goal[0] - here[0])
    far = min(150.0, math.dist(here, goal))
    for off in range(0, 181, 3):
        for side in (1, -1):
            turned = straight + side * math.radians(off)
            if free(here, turned, far, robots):
                return math.degrees(turned)
    return math.degrees(straight)
