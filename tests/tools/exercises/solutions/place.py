# SPDX-License-Identifier: Apache-2.0
import math


def cost(x, y, looks, seen, beacons):
    total = 0.0
    for (away, side), (bx, by) in zip(seen, beacons):
        far = math.dist((x, y), (bx, by))
        off = math.degrees(math.atan2(by - y, bx - x)) - looks - side
        total += ((away - far) / (0.1 * far)) ** 2 + off ** 2
    return total


def best_heading(x, y, seen, beacons):
    return sum(math.degrees(math.atan2(by - y, bx - x)) - side
               for (_, side), (bx, by) in zip(seen, beacons)) / 2.0


def pose_of(seen, beacons):
    x, y, step = 180.0, 270.0, 80.0
    while step > 0.5:
        places = [(x + i * step, y + j * step) for i in (0, -1, 1) for j in (0, -1, 1)]
        found = min(places, key=lambda p: cost(*p, best_heading(*p, seen, beacons), seen, beacons))
        if found == (x, y):
            step *= 0.5
        x, y = found
    return x, y, best_heading(x, y, seen, beacons)
