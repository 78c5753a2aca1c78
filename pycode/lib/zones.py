# SPDX-License-Identifier: Apache-2.0
# Where on the field a ball is: three zones by how far up it lies (thesis 2006 Alg 5.1) and the
# twelve sub-zones of figure 5.2. The widths of edges, corners and of the region close to the goal
# are open in the thesis (checklist U05, U22). Keeps nothing.
from lib.geom import Point

DEFENSIVE, MIDDLE, OFFENSIVE = range(3)
DEFENSIVE_END = 0.4   # share of the field's length
MIDDLE_END = 0.6  # share of the length
EDGE = 50.0           # cm from a side line
CORNER = 100.0        # cm: legs of the triangle in an upper corner
GOAL_CLOSE = 60.0     # cm before the opponents' goal line, between the posts and EDGE beside them

(DEFENSIVE_LEFT, DEFENSIVE_CENTRE, DEFENSIVE_RIGHT, MIDDLE_LEFT, MIDDLE_RIGHT, MIDDLE_CENTRE,
 OFFENSIVE_CENTRE, OFFENSIVE_LEFT, OFFENSIVE_RIGHT, CORNER_LEFT, CORNER_RIGHT,
 CLOSE_TO_GOAL) = range(1, 13)
EDGES = {DEFENSIVE_LEFT: -1, MIDDLE_LEFT: -1, OFFENSIVE_LEFT: -1,
         DEFENSIVE_RIGHT: 1, MIDDLE_RIGHT: 1, OFFENSIVE_RIGHT: 1}
CORNERS = {CORNER_LEFT: -1, CORNER_RIGHT: 1}


def zone(field, y) -> int:
    """DEFENSIVE, MIDDLE or OFFENSIVE by how far up-field (cm) the ball lies."""
    if y < DEFENSIVE_END * field.length:
        return DEFENSIVE
    return MIDDLE if y < MIDDLE_END * field.length else OFFENSIVE


def edge(field, x) -> int:
    """-1 at the left edge of the field, +1 at the right one, 0 between."""
    if x < EDGE:
        return -1
    return 1 if x > field.width - EDGE else 0


def corner(field, ball: Point) -> int:
    """-1 in the upper left corner's triangle, +1 in the right one, 0 elsewhere."""
    below = field.length - ball[1]
    if below + ball[0] < CORNER:
        return -1
    return 1 if below + field.width - ball[0] < CORNER else 0


def close_to_goal(field, ball: Point) -> bool:
    lateral = abs(ball[0] - 0.5 * field.width)
    return field.length - ball[1] < GOAL_CLOSE and lateral < 0.5 * field.goal_width + EDGE


def sub_zone(field, ball: Point) -> int:
    """One of the twelve, for any point of the field and around it."""
    side = edge(field, ball[0])
    region = zone(field, ball[1])
    if region == DEFENSIVE:
        return (DEFENSIVE_LEFT, DEFENSIVE_CENTRE, DEFENSIVE_RIGHT)[side + 1]
    if region == MIDDLE:
        return (MIDDLE_LEFT, MIDDLE_CENTRE, MIDDLE_RIGHT)[side + 1]
    in_corner = corner(field, ball)
    if in_corner:
        return CORNER_LEFT if in_corner < 0 else CORNER_RIGHT
    if close_to_goal(field, ball):
        return CLOSE_TO_GOAL
    return (OFFENSIVE_LEFT, OFFENSIVE_CENTRE, OFFENSIVE_RIGHT)[side + 1]
