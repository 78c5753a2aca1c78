# SPDX-License-Identifier: Apache-2.0
# The head sweeps between two pans, low and high in turn (hTrack.scan of thesis 2006 section 6.2.2).
# Keeps the row and the side it goes to, and when it turned last; it turns when the sensed pan has
# come so near to the end that the head, which follows late, gets there. Fast sweeps smear images.
import kelpie
from arbiter.skill import Skill
from lib.geom import clamp
from skills.ball.lost_ball import MAX_PAN

FRAMES_PER_S = 30.0  # 1/s
LOW_CRANE = -10.0  # deg,
HIGH_CRANE = 10.0  # deg
LOW_TILT = 0.0    # deg
HIGH_TILT = 0.0   # deg
LOW_SPEED = 8.0   # deg per frame
HIGH_SPEED = 9.0  # deg per frame
LOOK_DOWN_TILT = -30.0               # deg, where a ball at the feet may be (facts-2005 7.2)
LOOK_DOWN_WITHIN = 40.0              # deg of pan
MIN_NOD = -5.0                       # deg; with the neck up the head would touch it (openr.md 5.6)
# deg above the horizon: from 20 cm away to the horizon all is in the image, 45 deg high. Ours, for
# who does not know where the ball is; rows of joint angles look up at the sides of a leaning body.
LEVEL = -20.0
FEET_TILT = -30.0  # deg of the neck,
FEET_FRAMES = 3    # frames at the beginning: a ball may be at the feet
# deg per frame; standing at up to 2.2 m the robot sees a ball in 1.00 of the images at 8 and 10
# deg per frame, in 0.98 at 12, 0.92 at 16.
LEVEL_SPEED = 12.0
LATE_FRAMES = 4                      # from a command to the head's motion on the physical body
PATIENCE_S = 0.3                     # beyond a row's time, for a pan that does not get there


def head_params(pan, tilt, crane, speed=0.0) -> kelpie.HeadRequest:
    """Joint angles as the theses name them: pan, tilt of the neck, crane of the nod. What the nod
    may not go down the neck does."""
    nod = max(crane, MIN_NOD)
    return kelpie.HeadRequest(head_pan_deg=clamp(pan, -MAX_PAN, MAX_PAN),
                              neck_tilt_deg=tilt + crane - nod, head_nod_deg=nod, speed_deg=speed)


class ScanForBall(Skill):
    NAME = 'scan_for_ball'

    def __init__(self, side=1.0):
        self.side = side     # of the end that it goes to, +1 left
        self.low = True
        self.turned_s = None
        self.rows = 0        # that came to an end
        self.frames = 0      # of level()

    def step(self, world, limits=None) -> kelpie.HeadRequest:
        """`limits`: least and greatest pan, and whether to look down at the feet on the way; None:
        all around, at one elevation."""
        if limits is None:
            return self.level(world)
        min_pan, max_pan, look_down = limits
        end = self.next_end(world, min_pan, max_pan, self.speed())
        tilt, crane = (LOW_TILT, LOW_CRANE) if self.low else (HIGH_TILT, HIGH_CRANE)
        if look_down and self.low and abs(world.head.head_pan_deg) < LOOK_DOWN_WITHIN:
            tilt = LOOK_DOWN_TILT
        return head_params(end, tilt, crane, self.speed() * FRAMES_PER_S)

    def level(self, world) -> kelpie.HeadRequest:
        """The same in all directions and at one elevation, after a short look at the feet."""
        self.frames += 1
        end = self.next_end(world, -MAX_PAN, MAX_PAN, LEVEL_SPEED)
        speed = LEVEL_SPEED * FRAMES_PER_S
        if self.frames <= FEET_FRAMES:
            return head_params(end, FEET_TILT, MIN_NOD, speed)
        return kelpie.HeadRequest(aim=kelpie.AIM_DIRECTION, direction_deg=end, elevation_deg=LEVEL,
                                  speed_deg=speed)

    def next_end(self, world, min_pan, max_pan, speed) -> float:
        """The pan that it goes to; the row turns at its end."""
        end = max_pan if self.side > 0.0 else min_pan
        if self.at_end(world, end, max_pan - min_pan, speed):
            self.side, self.low, self.turned_s = -self.side, not self.low, world.time_s
            self.rows += 1
            end = max_pan if self.side > 0.0 else min_pan
        return end

    def speed(self) -> float:
        """deg per frame."""
        return LOW_SPEED if self.low else HIGH_SPEED

    def at_end(self, world, end, width, speed) -> bool:
        if self.turned_s is None:
            self.turned_s = world.time_s
        late = self.turned_s + width / (speed * FRAMES_PER_S) + PATIENCE_S
        reached = min(LATE_FRAMES * speed, 0.5 * width)
        return abs(world.head.head_pan_deg - end) < reached or world.time_s > late
