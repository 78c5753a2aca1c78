# SPDX-License-Identifier: Apache-2.0
# Walks to where a lost ball may be in sight, the head sweeping: first past the robots that may hide
# it, then to the middles of both halves in turn, without end. Keeps the place that it goes to,
# since when, and behind whom it has looked. Follows the eight steps of the search, of which the
# last sees about 3 m around. As wrong as the pose; knows no obstacles but those that it passes.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import from_field
from lib.steer import towards
from skills.head.scan_for_ball import ScanForBall

UPPER = 0.65               # share of the field's length,
LOWER = 0.35               # share of the field's length
NEAR = 30.0                # cm; arrived
LONGEST = 9.0              # s for one way
HIDES_WITHIN = 250.0       # cm; behind a robot farther away little is hidden that is not far, too
SEEN_WITHIN = 10.0         # s
BESIDE = 50.0  # cm,
BEYOND = 15.0  # cm from a robot, across and along the line of sight
SAME = 60.0                # cm; a robot so near to where one was is the same
EDGE = 30.0                # cm from the lines


class Roam(Skill):
    NAME = 'roam'

    def __init__(self, world):
        self.upper = world.pose.position.y < 0.5 * world.field.length
        self.place = None     # on the field
        self.begun_s = 0.0
        self.looked_behind = []  # places of robots
        self.scan = ScanForBall()

    def step(self, world) -> kelpie.Command:
        if self.place is None or self.arrived(world):
            self.place, self.begun_s = self.next_place(world), world.time_s
        return kelpie.Command(walk=towards(from_field(world.pose, *self.place)),
                              head=self.scan.step(world))

    def arrived(self, world) -> bool:
        """Or will not arrive any more."""
        late = world.time_s - self.begun_s > LONGEST
        return late or math.hypot(*from_field(world.pose, *self.place)) < NEAR

    def next_place(self, world):
        for robot in sorted(hiding(world)):
            if all(math.hypot(robot[1] - x, robot[2] - y) > SAME for x, y in self.looked_behind):
                self.looked_behind.append(robot[1:])
                return beside(world, *robot)
        share = UPPER if self.upper else LOWER
        self.upper = not self.upper
        return 0.5 * world.field.width, share * world.field.length


def hiding(world):
    """(distance, x, y) of opponents behind which a ball may lie."""
    here = world.pose.position
    for robot in world.opponents:
        away = math.hypot(robot.position.x - here.x, robot.position.y - here.y)
        if NEAR < away < HIDES_WITHIN and robot.seconds_since_seen < SEEN_WITHIN:
            yield away, robot.position.x, robot.position.y


def beside(world, away, x, y):
    """The place on the field beside a robot from which the other side of it is in sight: of two,
    the one nearer to the middle of the field."""
    here, field = world.pose.position, world.field
    along, across = (x - here.x) / away, (y - here.y) / away
    places = [(x + BEYOND * along - side * BESIDE * across, y + BEYOND * across +
               side * BESIDE * along) for side in (1.0, -1.0)]
    middle = 0.5 * field.width, 0.5 * field.length
    px, py = min(places, key=lambda place: math.hypot(place[0] - middle[0], place[1] - middle[1]))
    return (min(max(px, EDGE), field.width - EDGE), min(max(py, EDGE), field.length - EDGE))
