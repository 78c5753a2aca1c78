# SPDX-License-Identifier: Apache-2.0
# The head sweeps between two pans, low and high in turn (hTrack.scan of thesis 2006 section 6.2.2).
# Keeps the row and the side it goes to, and when it turned last; it turns when the sensed pan has
# come near the end, so a slow servo only makes it slower. Fast sweeps smear images.
import kelpie
from lib.geom import clamp
from lib.lost_ball import MAX_PAN

FRAMES_PER_S = 30.0
LOW_CRANE, HIGH_CRANE = -10.0, 10.0  # deg
LOW_TILT, HIGH_TILT = 0.0, 0.0
LOW_SPEED, HIGH_SPEED = 8.0, 9.0     # deg per frame
LOOK_DOWN_TILT = -30.0               # deg, where a ball at the feet may be (facts-2005 7.2)
LOOK_DOWN_WITHIN = 40.0              # deg of pan
LEAST_NOD = -5.0                     # deg; with the neck up the head would touch it (openr.md 5.6)
REACHED = 8.0                        # deg from the end of a row: one frame's way
PATIENCE_S = 0.3                     # beyond a row's time, for a pan that does not get there


def head_params(pan, tilt, crane, speed=0.0) -> kelpie.HeadRequest:
    """Joint angles as the theses name them: pan, tilt of the neck, crane of the nod. What the nod
    may not go down the neck does."""
    nod = max(crane, LEAST_NOD)
    return kelpie.HeadRequest(head_pan_deg=clamp(pan, -MAX_PAN, MAX_PAN),
                              neck_tilt_deg=tilt + crane - nod, head_nod_deg=nod, speed_deg=speed)


class ScanForBall:
    def __init__(self, side=1.0):
        self.side = side     # of the end that it goes to, +1 left
        self.low = True
        self.turned_s = None

    def head(self, world, min_pan=-MAX_PAN, max_pan=MAX_PAN,
             look_down=False) -> kelpie.HeadRequest:
        end = max_pan if self.side > 0.0 else min_pan
        if self.at_end(world, end, max_pan - min_pan):
            self.side, self.low, self.turned_s = -self.side, not self.low, world.time_s
            end = max_pan if self.side > 0.0 else min_pan
        tilt, crane = (LOW_TILT, LOW_CRANE) if self.low else (HIGH_TILT, HIGH_CRANE)
        if look_down and self.low and abs(world.head.head_pan_deg) < LOOK_DOWN_WITHIN:
            tilt = LOOK_DOWN_TILT
        return head_params(end, tilt, crane, self.speed() * FRAMES_PER_S)

    def speed(self) -> float:
        """deg per frame."""
        return LOW_SPEED if self.low else HIGH_SPEED

    def at_end(self, world, end, width) -> bool:
        if self.turned_s is None:
            self.turned_s = world.time_s
        late = self.turned_s + width / (self.speed() * FRAMES_PER_S) + PATIENCE_S
        return abs(world.head.head_pan_deg - end) < REACHED or world.time_s > late
