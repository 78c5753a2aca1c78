# SPDX-License-Identifier: Apache-2.0
# With the ball around whoever stands in the way (thesis 2006 section 6.4.4): infrared or dark
# pixels ahead start a step to a side, which goes on until nothing is there for some frames. Keeps
# the side and the frames that are still to be free. The side comes from where the robot is, before
# the opponents' goal from the wider gap. It cannot see who stands beside it.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook
from situation import aim, obstacles
from situation.infrared import somebody_near
from skills.ball.hold import SIDE_SPEED, carry

PIXELS = 12            # obstacle points in the box of 50 x 100 cm ahead (U07)
MAP_COUNT = 12.0       # of the obstacle map in the corridor ahead
AHEAD = 45.0  # cm,
LATERAL = 15.0         # cm of that corridor: to its end, to each side
GOALIE_BOX = 60.0      # cm before the goal line: there it is the goalie
RELEASE_GOALIE = 7  # frames,
RELEASE_OTHER = 30  # frames
EDGE = 60.0            # cm from a side line
CORNER = 100.0         # cm around an upper corner


def in_the_way(world) -> bool:
    """Somebody stands ahead, by infrared or by what the camera sees, or saw before."""
    if somebody_near(world):
        return True
    if world.percepts.obstacles_ahead >= PIXELS:
        return True
    if not rulebook.of(world).DODGES_BY_MAP:
        return False
    points = obstacles.points_near(world, world.pose.position, math.hypot(LATERAL, AHEAD))
    return obstacles.in_box(points, world.pose, -LATERAL, LATERAL, 15.0, AHEAD) >= MAP_COUNT


def side_by_place(field, x, y) -> float:
    """Alg 6.7: +1 to the left, -1 to the right, for a robot that looks up-field."""
    below = field.length - y
    if x < EDGE or (x < CORNER and below < CORNER):
        return -1.0
    if x > field.width - EDGE or (x > field.width - CORNER and below < CORNER):
        return 1.0
    left_half = x < 0.5 * field.width
    if y > 0.5 * field.length:
        return -1.0 if left_half else 1.0
    return 1.0 if left_half else -1.0


def side_by_gaps(left, right, goal_heading) -> float:
    """Before the goal: the wider gap's side; without gaps the middle of the goal's."""
    if left is not None and right is not None:
        return 1.0 if aim.size(left) > aim.size(right) else -1.0
    return 1.0 if goal_heading >= 0.0 else -1.0


class Dodge(Machine):
    NAME = 'dodge'

    def __init__(self, world, memory):
        super().__init__(self.left if self.side_to(world, memory) > 0.0 else self.right)
        self.release = self.frames(world)
        self.free_left = self.release
        self.why = 'somebody is ahead, infrared {} cm'
        self.numbers = (world.sensors.head_near_distance,)

    def side_to(self, world, memory) -> float:
        place = world.pose.position
        if self.frames(world) == RELEASE_GOALIE:
            return side_by_gaps(*aim.gaps_of(world), memory.goal_heading)
        return side_by_place(world.field, place.x, place.y)

    def frames(self, world) -> int:
        to_line = world.field.length - world.pose.position.y
        before_goal = to_line < GOALIE_BOX + world.field.box_depth
        return RELEASE_GOALIE if before_goal else RELEASE_OTHER

    @property
    def done(self) -> bool:
        return self.free_left <= 0

    def step(self, world) -> kelpie.Command:
        self.free_left = self.release if in_the_way(world) else self.free_left - 1
        return super().step(world)

    def left(self, world):
        return carry(left=SIDE_SPEED)

    def right(self, world):
        return carry(left=-SIDE_SPEED)
