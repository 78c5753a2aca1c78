# SPDX-License-Identifier: Apache-2.0
# Backs off when a front paw pushes at something in its swing (thesis 2006 section 4.3.3): straight
# back from both paws, back and to the other side from one, for a certain time. A robot that walks
# ahead and is felt to be held counts as both: on the physical body two heads meet before any paw
# does; of 5 walks at a standing robot 4 get past it within 16 s, by paws alone none. So does one
# that comes no nearer to a ball in view (situation/headway.py). What backs into something else goes
# on with its play instead and heeds no paw for a while: a robot in a goal once backed into its
# corner for 100 s. Keeps until when, to which side, and when it last backed straight. Feels nothing
# while it stands. A paw that a near ball presses is the contested ball's matter.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook
from situation.headway import Headway

BACK_S = 0.8          # ours; the body feels a paw for 0.4 s after it was pressed
BACK_SPEED = -24.0    # cm/s
SIDE_SPEED = 18.0  # cm/s
# Whoever was met head on so recently is passed on the right, as it does the same. Of 51 meetings
# of two discs (tests/py/walk/test_paw_stuck.py) all end within 45 s; 36 do when both back straight
# again.
AGAIN_S = 4.0
FELT_S = 0.5          # what is felt in the first of it is still what held it from ahead
DEAF_S = 0.5          # between two times of backing: whoever always backs never gets away
HELD_DEAF_S = 2.5     # after backing was of no use: a turn by 180 deg and a step
BALL_AT_PAWS = 30.0   # cm
WALKS_AHEAD = 8.0     # cm/s
PUSHES_ON_S = 1.2     # for which who runs with the ball pushes at what holds it: it is the ball, or
                      # an opponent who wants it


def blocked(world) -> tuple[bool, bool]:
    """Whether the left and the right front paw push at something that is not the ball."""
    ball, feeling = world.ball, world.motion.feeling
    if ball.present and ball.distance < BALL_AT_PAWS:
        return False, False
    held = feeling.stuck and rulebook.of(world).FEELS_HELD
    if held and world.last_command.walk.forward > WALKS_AHEAD:
        return True, True
    left, right = feeling.paw_blocked
    return left, right


def paw_pushes(now, playing):
    """The rule of who backs off, of a situation whose `paw_pushes` its player worked out."""
    return ('a front paw pushes at something',) if now.paw_pushes else None


class PawStuck(Machine):
    NAME = 'paw_stuck'

    def __init__(self, pushes_on=False):
        """`pushes_on`: of who plays the ball, and pushes it where it runs (lib/rulebook.py)."""
        super().__init__(self.free)
        self.pushes_on = pushes_on
        self.free_s = 0.0       # when nothing held it last
        self.straight_s = None  # when it last backed straight
        self.deaf_until_s = -math.inf
        self.headway = Headway()

    def update(self, world) -> None:
        """To be called once in every frame."""
        self.headway.update(world)
        if not world.motion.feeling.stuck:
            self.free_s = world.time_s

    def felt(self, world) -> tuple[bool, bool, bool]:
        """What is felt: by the left and the right paw, and by a ball that comes no nearer."""
        if self.pushes_on and rulebook.runs(world):
            held = world.time_s - self.free_s > PUSHES_ON_S
            return held, held, False
        return *blocked(world), rulebook.of(world).FEELS_HELD and self.headway.none

    def needed(self, world) -> bool:
        """Whether it backs in this frame; may be asked more than once."""
        if self.state != self.free and not self.ended(world):
            return True
        left, right, held = self.felt(world)
        ours = rulebook.of(world).FEELS_HELD
        if not (left or right or held) or (ours and world.time_s < self.deaf_until_s):
            return False
        self.begin(world, left or held, right or held)
        return True

    def ended(self, world) -> bool:
        held = (world.motion.feeling.stuck and rulebook.of(world).FEELS_HELD and
                self.timed_out(world, FELT_S))
        if not held and not self.timed_out(world, BACK_S):
            return False
        self.deaf_until_s = (world.time_s + HELD_DEAF_S if held else
                             self.entered_s + BACK_S + DEAF_S)
        self.enter(world, self.free, None, 'something is behind' if held else 'has backed off')
        return True

    def begin(self, world, left, right):
        self.headway.begin_at(math.inf)
        again = (rulebook.of(world).FEELS_HELD and self.straight_s is not None and
                 world.time_s - self.straight_s < AGAIN_S)
        if left and right and not again:
            self.straight_s = world.time_s
            self.enter(world, self.back, None, 'held, or both front paws are blocked')
        elif left and right:
            self.enter(world, self.back_right, None, 'held from ahead again')
        elif left:
            self.enter(world, self.back_right, None, 'the left front paw is blocked')
        else:
            self.enter(world, self.back_left, None, 'the right front paw is blocked')

    def step(self, world) -> kelpie.Command:
        """The head looks ahead, a little down."""
        return kelpie.Command(walk=super().step(world), head=kelpie.HeadRequest(
            aim=kelpie.AIM_DIRECTION, elevation_deg=-10.0))

    def free(self, world):
        return kelpie.WalkRequest()

    def back(self, world):
        return kelpie.WalkRequest(forward=BACK_SPEED)

    def back_left(self, world):
        return kelpie.WalkRequest(forward=BACK_SPEED, left=SIDE_SPEED)

    def back_right(self, world):
        return kelpie.WalkRequest(forward=BACK_SPEED, left=-SIDE_SPEED)
