# SPDX-License-Identifier: Apache-2.0
# Where each forward looks for a ball that the whole team lost, and who goes where (thesis 2006
# section 6.2.2, figure 6.1; checklist G34). Keeps nothing. Robots whose poses are wrong may choose
# the same place.
import math


def places(field) -> list:
    """(180, 162), (80, 378) and (280, 378) on the field of 2006."""
    return [(0.5 * field.width, 0.3 * field.length), (80.0, 0.7 * field.length),
            (field.width - 80.0, 0.7 * field.length)]


def assigned(field, robots) -> dict:
    """The place of each player. `robots`: (player, x, y) of the forwards; the closest to the first
    place takes it, then the closest of the others the second."""
    left, found = sorted(robots), {}
    for place in places(field):
        if not left:
            break
        best = min(left, key=lambda robot: (math.hypot(robot[1] - place[0], robot[2] - place[1]),
                                            robot[0]))
        found[best[0]] = place
        left.remove(best)
    for robot in left:   # a fourth forward looks in the middle
        found[robot[0]] = (0.5 * field.width, 0.5 * field.length)
    return found
