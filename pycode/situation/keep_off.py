# SPDX-License-Identifier: Apache-2.0
# Which ways of the play a non-attacker leaves free (thesis 2006 section 4.3.3, figures 4.4 and
# 4.5): plain geometry of field points in cm. A Lane is a segment and how far to keep off it. Keeps
# nothing. Takes the attacker's way to be straight, and its shot to go to the goal's middle.
import math

import kelpie
from lib.geom import clamp
from lib.paths import attacker_of, goal_of, point_of

CLEARANCE = 44.0     # cm: 40 (U03) and what it still walks when it turns away
HOLDER_LINE = 60.0   # cm off the line of one that holds the ball, and
REACH = 250.0        # cm of that line (facts-2005 section 7.2, get out of the way)
SPARE = 10.0         # cm beyond the clearance that one goes, so that it is left for good
EDGE = 25.0          # cm to side and end lines
HAS = 35.0           # cm; an attacker so near to the ball has it

HOLDS = 'holds'
HAS_BALL = 'has_ball'
ON_WAY = 'on_way'


class Lane:
    def __init__(self, kind, start, end, clearance):
        self.kind, self.start, self.end, self.clearance = kind, start, end, clearance

    def gap(self, point) -> float:
        """cm from a point to the segment."""
        x, y = self.foot(point)
        return math.hypot(point[0] - x, point[1] - y)

    def foot(self, point):
        dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        length2 = dx * dx + dy * dy or 1.0
        share = clamp(((point[0] - self.start[0]) * dx + (point[1] - self.start[1]) * dy) /
                      length2, 0.0, 1.0)
        return self.start[0] + share * dx, self.start[1] + share * dy

    def way_off(self, field, point):
        """The nearest place beside the segment; the other side's when that is off the field."""
        dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        length = math.hypot(dx, dy)
        if length < 1.0:
            dx, dy, length = 0.0, 1.0, 1.0
        x, y = self.foot(point)
        left = (point[1] - y) * dx - (point[0] - x) * dy
        side = 1.0 if left > 0.0 or (left == 0.0 and x > 0.5 * field.width) else -1.0
        keep = self.clearance + SPARE
        places = [(x - turn * keep * dy / length, y + turn * keep * dx / length)
                  for turn in (side, -side)]
        return next((place for place in places if on_field(field, place)),
                    inside(field, places[0]))


def lanes(world, ball) -> list:
    """What is kept free of others now; the most important one first."""
    if ball is None:
        return []
    goal = goal_of(world.field)
    found = [Lane(HOLDS, point_of(mate.pose), towards(point_of(mate.pose), goal), HOLDER_LINE)
             for mate in world.teammates if mate.note.grabs == kelpie.HOLDS]
    if found:
        return found
    mate = attacker_of(world)
    if mate is None:
        return []
    place = point_of(mate.pose)
    near = math.hypot(place[0] - ball[0], place[1] - ball[1]) < HAS
    if near or mate.note.grabs == kelpie.GRABS_SOON:
        return [Lane(HAS_BALL, ball, towards(ball, goal), CLEARANCE),
                Lane(ON_WAY, place, ball, CLEARANCE)]
    return [Lane(ON_WAY, place, ball, CLEARANCE)]


def towards(start, end):
    """The end, or a point REACH before the start."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    share = min(1.0, REACH / max(math.hypot(dx, dy), 1.0))
    return start[0] + share * dx, start[1] + share * dy


def cleared(field, place, kept):
    """A place, moved off the lanes that it lies in."""
    for lane in kept:
        if lane.gap(place) < lane.clearance:
            place = lane.way_off(field, place)
    return out_of_box(field, place)


def on_field(field, place) -> bool:
    return (EDGE <= place[0] <= field.width - EDGE and EDGE <= place[1] <= field.length - EDGE and
            place == out_of_box(field, place))


def inside(field, place):
    return out_of_box(field, (clamp(place[0], EDGE, field.width - EDGE),
                              clamp(place[1], EDGE, field.length - EDGE)))


def out_of_box(field, place):
    """Only the goalie is in the own box: a place in it is moved before it."""
    in_width = abs(place[0] - 0.5 * field.width) < 0.5 * field.box_width + SPARE
    top = field.box_depth + SPARE
    return (place[0], top) if in_width and place[1] < top else place
