# SPDX-License-Identifier: Apache-2.0
# Looks at a landmark briefly and back to the ball (active localisation, thesis 2006 section 4.3.2;
# numbers of U02 and facts-2005 section 7.2): an attacker after a spin for a far ball, when nothing
# else needs the head; who waits (goalie, challenger, supporter) from time to time, and at once when
# the pose is bad. Keeps the landmark of this look and since when; when it looked last is in the
# memory. With a pose that is wrong by much it looks at nothing.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook
from lib.geom import from_field, heading
from lib.landmarks import ATTACKER_PAN, choose_landmark, look_at_landmark
from skills.head.track_ball import TrackBall, believed

SEEN = 5              # frames in a row in which the ball was seen
FAR = 100.0           # cm
AHEAD = 10.0          # deg
CLOSE = 60            # frames since the ball was close,
APPROACHED = 60       # a grab was approached
LOOKED = 60           # or a landmark looked at, all no longer recent
LEAVE = 50.0          # cm; a ball that comes so near is looked at again
LOOK_FRAMES = 10      # of which a head needs 5 for 70 deg
SIGHTINGS = 2         # of the landmark that are enough
BACK_FRAMES = 10      # for the head to find the ball again
DUE_SOONEST = 45  # frames,
DUE_LATEST = 120  # frames between looks of who waits
BAD_SD = 55.0  # cm,
BAD_HEADING_SD = 25.0  # deg
GOOD_SD = 5.0         # cm; a pose this sure is looked after as seldom as allowed


def attacker_may_look(world, memory) -> bool:
    """All six conditions of thesis 2006 section 4.3.2."""
    ball = world.ball
    rules = rulebook.of(world)
    approach_lost = memory.approach_near_lost if rules.APPROACHES_NEAR else memory.approach_lost
    return (memory.spin_lost <= rules.SPUN and memory.ball_run >= SEEN
            and ball.distance > FAR and abs(ball.heading_deg) < AHEAD
            and memory.close_lost > CLOSE and approach_lost > APPROACHED
            and memory.localised_lost > LOOKED)


def due(world, memory) -> bool:
    """For who waits: the less sure the pose, the sooner; a bad one at the soonest."""
    if memory.localised_lost <= DUE_SOONEST:
        return False
    bad = world.position_sd >= BAD_SD or world.heading_sd_deg >= BAD_HEADING_SD
    return bad or memory.localised_lost > interval(world.position_sd)


def interval(position_sd) -> float:
    """Frames from look to look: the latest up to GOOD_SD, the soonest from BAD_SD on."""
    share = (position_sd - GOOD_SD) / (BAD_SD - GOOD_SD)
    return DUE_LATEST - min(1.0, max(0.0, share)) * (DUE_LATEST - DUE_SOONEST)


class LandmarkLook(Machine):
    """What all looks at landmarks have in common: for some frames the head is off the ball, and the
    memory knows since when the last one was."""

    def __init__(self, memory, state):
        super().__init__(state)
        self.memory = memory
        self.mark = None    # the landmark of this look
        self.frames = 0     # of it so far

    def look_on(self) -> None:
        """One more frame off the ball."""
        self.frames += 1
        self.memory.looked_for_landmarks()


class ActiveLocalise(LandmarkLook):
    NAME = 'active_localise'

    def __init__(self, memory, pan_limit=ATTACKER_PAN, may_look=attacker_may_look):
        super().__init__(memory, self.look)
        self.pan_limit = pan_limit
        self.may_look = may_look
        self.track = TrackBall(memory)
        self.sightings = 0

    def needed(self, world) -> bool:
        """Whether a look begins: it may, and there is something to look at."""
        return self.may_look(world, self.memory) and self.landmark(world) is not None

    def landmark(self, world):
        """The one to look at from here, or None."""
        return choose_landmark(world, self.pan_limit, world.head.head_pan_deg)

    def start(self, world) -> None:
        """Begins a look that is needed."""
        self.mark = self.landmark(world)
        self.frames = self.sightings = 0
        axis = heading(*from_field(world.pose, self.mark.position.x, self.mark.position.y))
        self.enter(world, self.look, None, 'the pose is sure to {} cm; a landmark at {} deg',
                   world.position_sd, axis)

    @property
    def done(self) -> bool:
        return self.state == self.back and (self.memory.ball_lost == 0 or
                                            self.frames >= BACK_FRAMES)

    def look(self, world):
        self.look_on()
        self.sightings += any(mark.kind == self.mark.kind for mark in world.percepts.landmarks)
        near = world.ball.present and math.hypot(*believed(world)) < LEAVE
        if self.frames > LOOK_FRAMES or self.sightings >= SIGHTINGS or near:
            why = 'the ball is near' if near else 'landmark seen {} times'
            numbers = () if near else (self.sightings,)
            self.frames = 0
            return self.enter(world, self.back, None, why, *numbers)
        return look_at_landmark(world, self.mark)

    def back(self, world):
        self.frames += 1
        return self.track.step(world)
