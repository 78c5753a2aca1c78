# SPDX-License-Identifier: Apache-2.0
# Places of the field that tell a robot where it is (thesis 2004 section 4.1.6), from the lines of
# world.field: where lines end, meet or cross and the middle of the centre circle are primary;
# halfway between two of them on one line is secondary, for a look at the line alone. Keeps nothing.
from lib.geom import Point

FEATURE_OFF = 15.0  # cm; one nearer to a goal point is not faced there
BEHIND = 25.0  # cm
SAME = 4.0  # cm; a corner is the end of two lines whose middles are half a line's width apart


def primary(field) -> list[Point]:
    """Ends of lines and the middle, each once."""
    places = []
    ends = [end for line in field.lines for end in (line.start, line.end)]
    centre = (0.5 * field.width, 0.5 * field.length)
    for place in [(end.x, end.y) for end in ends] + [centre]:
        if all(distance(place, other) > SAME for other in places):
            places.append(place)
    return places


def secondary(field) -> list[Point]:
    """Halfway between neighbouring primary features of each line, but in the mouths of goals."""
    places = []
    for line in field.lines:
        stops = sorted(p for p in primary(field) if off_line(p, line) < SAME)
        for a, b in zip(stops, stops[1:]):
            middle = (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
            if not in_goal(field, middle):
                places.append(middle)
    return places


def to_face(field, point) -> Point:
    """The primary feature that a robot is to face at a goal point: the closest one that is not too
    near."""
    return min((place for place in primary(field) if distance(place, point) > FEATURE_OFF),
               key=lambda place: distance(place, point))


def behind(field, point) -> Point:
    """The place a little behind a goal point on the line from the feature to be faced there (thesis
    2004 section 4.1.6): who turns to the point then faces both."""
    feature = to_face(field, point)
    share = BEHIND / distance(feature, point)
    return (point[0] + share * (point[0] - feature[0]), point[1] + share * (point[1] - feature[1]))


def in_goal(field, place) -> bool:
    lateral = abs(place[0] - 0.5 * field.width)
    off_end = min(abs(place[1]), abs(place[1] - field.length))
    return lateral < 0.5 * field.goal_width and off_end < field.border_width + SAME


def distance(a, b) -> float:
    return ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5


def off_line(place, line) -> float:
    """Distance of a place from the piece between a line's ends."""
    dx, dy = line.end.x - line.start.x, line.end.y - line.start.y
    along = ((place[0] - line.start.x) * dx + (place[1] - line.start.y) * dy) / (dx * dx + dy * dy)
    share = max(0.0, min(1.0, along))
    return distance(place, (line.start.x + share * dx, line.start.y + share * dy))
