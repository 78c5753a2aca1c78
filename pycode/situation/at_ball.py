# SPDX-License-Identifier: Apache-2.0
# What the decision tree asks about, worked out once for a frame: plain numbers of ball, robot and
# field. Headings are in degrees, left positive; those of the field count from straight up-field.
# Keeps nothing. As wrong as pose and ball.
import math

from lib import rulebook, zones
from lib.geom import TURN, heading, wrap
from situation.goal import UP_FIELD_DEG

CENTRE_OFFSET = 60.0   # cm up-field of the ball: the point whose bearing is `up` (checklist G29)
GOAL_CROSSING = 20.0   # cm before the goal line: "front of the target goal", thesis 2006 Alg 5.7
NEAR_LINE = 30.0       # cm: "really close to the goal line" (U22)
FAR_OUT = 250.0        # cm to the goal: "still very far"
NEAR_CENTRE = 60.0     # cm from the middle of the width
FACING_GOAL = 15.0     # deg


def direction(x0, y0, x1, y1) -> float:
    """From one point of the field to another, in deg on the field."""
    return math.degrees(math.atan2(y1 - y0, x1 - x0))


def up_field(x0, y0, x1, y1) -> float:
    """Direction from one point of the field to another, degrees left of up-field."""
    return wrap(direction(x0, y0, x1, y1) - UP_FIELD_DEG)


class Situation:
    """All that Alg 5.1 to 5.7 test. `up`: the thesis' selfH2CenterH; `crossing`: its
    selfH2CrossingH; `ball_to_goal`: its ballH2TGoalH; `off_goal`: the difference that Alg 5.4
    tests (checklist G30). Of `side_edge`, `corner` and `edge`, which is either with a ball within
    50 cm of a side line, -1 is left and +1 right."""

    def __init__(self, world, contested: bool, about_to_grab: bool):
        field, relative = world.field, world.ball.relative
        place, looks = world.pose.position, world.pose.heading_deg
        robot_x, robot_y = place.x, place.y
        x, y = self.ball = world.ball.position.x, world.ball.position.y
        goal_x, goal_y = 0.5 * field.width, field.length
        self.contested, self.about_to_grab = contested, about_to_grab
        self.rules = rulebook.of(world)
        self.by_kick_map = rulebook.by_kick_map(world)
        self.zone = zones.zone(field, y)
        sub_zone = zones.sub_zone(field, self.ball)
        self.side_edge = zones.EDGES.get(sub_zone, 0)
        self.corner = zones.CORNERS.get(sub_zone, 0)
        self.edge = self.side_edge or self.corner * (zones.edge(field, x) != 0)
        self.facing = wrap(looks - UP_FIELD_DEG)
        self.ball_bearing = heading(relative.x, relative.y)
        self.up = wrap(direction(robot_x, robot_y, x, y + CENTRE_OFFSET) - looks)
        self.to_goal = wrap(direction(robot_x, robot_y, goal_x, goal_y) - looks)
        self.ball_to_goal = up_field(x, y, goal_x, goal_y)
        way = self.facing + self.ball_bearing
        self.crossing = wrap(way - up_field(x, y, goal_x, goal_y - GOAL_CROSSING))
        self.off_goal = wrap(way - self.ball_to_goal)
        self.goal_distance = math.hypot(x - goal_x, y - goal_y)
        self.line_distance = goal_y - y
        self.near_centre = abs(x - goal_x) < NEAR_CENTRE

    @property
    def strike_side(self) -> int:
        """At which side of the field a held ball may be struck in, as `edge`."""
        return self.edge if self.rules.STRIKES_FROM_EDGES else self.corner

    @property
    def own_goal_ahead(self) -> bool:
        """Whether the way to the ball leads down-field: so would the ball go that is driven on."""
        return self.across > 180.0

    @property
    def across(self) -> float:
        """The ball's bearing on the field from 0 to 360 as Alg 5.4 has it: 90 is up-field."""
        return (self.facing + self.ball_bearing + UP_FIELD_DEG) % TURN
