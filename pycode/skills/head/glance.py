# SPDX-License-Identifier: Apache-2.0
# A short look of the head at a landmark while the legs walk on to a ball that is not near yet: the
# attacker's active localisation between the spins after which thesis 2006 section 4.3.2 asks for
# one. Looks at what was not seen for longest; without a pose to go by it sweeps to a side. Keeps
# the landmark, the frames of this look and the side. One landmark alone, seen again and again,
# leaves a robot at the wrong place of a circle about it: in match 3 of the simulator 150 cm off for
# a minute.
import math

import kelpie
from lib import rulebook
from lib.head import view
from lib.landmarks import ATTACKER_PAN, in_reach, look_at_landmark
from skills.head.active_localise import LandmarkLook

EVERY = 70             # frames between looks; 45 to 120 in facts-2005 section 7.2
EVERY_BAD = 22         # with a bad pose
NEAR = 45.0            # cm; a nearer ball needs the head
SEEN = 8               # frames in a row with the ball before a look
SLOW = 15.0            # cm/s; of a ball that rolls faster the velocity must be seen
LOOK = 11              # frames
BAD_SD = 20.0  # cm,
BAD_HEADING_SD = 9.0  # deg
SWEEP_PAN = 60.0       # deg
SWEEP_DOWN = 4.0       # deg below the horizon


def bad(world) -> bool:
    return world.position_sd > BAD_SD or world.heading_sd_deg > BAD_HEADING_SD


class Glance(LandmarkLook):
    NAME = 'glance'

    def __init__(self, memory):
        super().__init__(memory, self.none)
        self.side = 1.0

    @property
    def looking(self) -> bool:
        return self.state != self.none

    def takes_head(self, world, free) -> bool:
        """Whether the head is taken in this frame; `free`: the skill could do without it."""
        if not free:
            self.state = self.none
        elif not self.looking and self.due(world):
            self.begin(world)
        return self.looking

    def due(self, world) -> bool:
        if not rulebook.of(world).GLANCES:
            return False
        every = EVERY_BAD if bad(world) else EVERY
        velocity = world.ball.velocity
        if math.hypot(velocity.x, velocity.y) > SLOW:
            return False
        return (world.ball.distance > NEAR and self.memory.ball_run >= SEEN and
                self.memory.localised_lost > every)

    def begin(self, world):
        self.frames = 0
        marks = [mark for mark, _, _ in in_reach(world, ATTACKER_PAN)]
        if bad(world) or not marks:
            self.side = -self.side
            self.enter(world, self.sweep, None, 'the pose is sure to {} cm only',
                       world.position_sd)
        else:
            self.mark = min(marks, key=lambda mark: self.memory.marks.get(mark.kind, -1))
            self.enter(world, self.look, None, 'the landmark seen longest ago')

    def step(self, world) -> kelpie.HeadRequest:
        self.look_on()
        request = self.state(world)
        if self.frames >= LOOK:
            self.state = self.none
        return request

    def none(self, world):
        return view(0.0, SWEEP_DOWN, world.stance)

    def look(self, world):
        return look_at_landmark(world, self.mark)

    def sweep(self, world):
        return view(self.side * SWEEP_PAN, SWEEP_DOWN, world.stance)
