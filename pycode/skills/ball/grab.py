# SPDX-License-Identifier: Apache-2.0
# Walks at the ball and takes it between chin, chest and forelegs (thesis 2006 section 6.3): no side
# steps, "can I grab" by six predicted frames, then the motion of 12 frames, or of 6 when the
# infrared says that the ball is close, by the theses' rules also midway. Keeps the state and when
# the motion was asked for. Whether the ball is held it leaves to what the body feels afterwards
# (skills/ball/hold.py). Begun too early the jaw comes down on the ball and pushes it away; late
# does no harm.
import math

import kelpie
from arbiter.machine import Machine
from lib import hints, intercept, rulebook
from lib.geom import clamp, heading
from situation.infrared import near
from skills.ball.hold import carry
from skills.head.track_ball import TrackBall

CONSTANTS = kelpie.constants.grab  # behaviour/constants.toml: defaults and ranges
TURN_GAIN = 0.9          # Alg of section 6.3.3: the heading less 10 %, against over-turning
TURN_SPEED = 120.0       # deg/s while it walks ahead,
SPIN_SPEED = 200.0       # and on the spot with the turning walk,
SPIN_FROM = 50.0         # deg: for a ball farther off,
SPIN_UNTIL = 30.0        # until it is no farther than this
FAST_FROM = CONSTANTS.fast_from  # cm: from there on the fast walk, if the ball is ahead
FAST_WITHIN = 20.0       # deg,
FAST_UNTIL = 30.0        # until it is farther
CLOSING = CONSTANTS.closing  # cm/s at least, ball ahead: slower, and the jaw meets the ball
SPEED = 36.0             # cm/s

PREDICTED = 6            # frames
DRAG = 0.9               # of a velocity per predicted frame, Alg 6.3
SIDE = 3.0               # cm
AHEAD = 13.5             # cm
TURNED = 15              # frames since a large turn; before that nearer only (G40)
AFTER_TURN = 0.75  # share of AHEAD
FRAME_S = 1.0 / 30.0  # s

SEEN_S = 0.2             # s: nobody grabs a ball that it has not just seen
GRABS = (kelpie.GRAB, kelpie.GRAB_QUICK, kelpie.GRAB_LIFT)
MAX_PAN = 30.0           # deg; a ball between the paws is never farther aside
IR_NEAR = 11.5           # cm of the chest's filtered infrared, which reads the carpet at 14
HURRIES_S = 0.3          # s since it was asked for: later the motion may end before it hears of it
FORWARD = 8.0            # cm/s that the motion ends with (actuator/data/motions/grab.toml)
HINT_WITHIN = 40.0       # cm; a far ball that is lost need not be where the paws are
START_S = 0.5            # for the motion to begin
LONGEST_S = 2.0  # s
PAWS_NEAR = 3.0  # cm,
PAWS_FAR = 11.0  # cm ahead of the neck: there a gripped ball lies,
PAWS_LATERAL = 4.0  # and so far to the side (docs/physical-body.md)


def walk_kind(away, off_deg, last):
    """The walk for a point that far away and off, when `last` is walked. Each is left later than
    it is begun: two walks that took turns every frame cost the odometry 15 deg in a second."""
    if abs(off_deg) > (SPIN_UNTIL if last == kelpie.WALK_TURNING else SPIN_FROM):
        return kelpie.WALK_TURNING
    fast = last == kelpie.WALK_FAST
    if away > FAST_FROM and abs(off_deg) < (FAST_UNTIL if fast else FAST_WITHIN):
        return kelpie.WALK_FAST
    return kelpie.WALK


def approach(point, last=kelpie.WALK) -> kelpie.WalkRequest:
    """Straight at a point of the robot frame: walk(d cos h, 0, 0.9 h), section 6.3.3."""
    away, off_deg = math.hypot(*point), heading(*point)
    ahead = math.cos(math.radians(off_deg))
    return kelpie.WalkRequest(forward=max(0.0, away * ahead), left=0.0,
                              turn_deg=TURN_GAIN * off_deg, kind=walk_kind(away, off_deg, last))


def limited(request, off_deg, times) -> kelpie.WalkRequest:
    """What the legs can do of it, no slower ahead than a grab needs, and turned to so many times as
    fast as the thesis has it: 0.9 /s curves past a ball 30 deg off."""
    if request.kind == kelpie.WALK_TURNING:
        speed = clamp(3.0 * off_deg, -SPIN_SPEED, SPIN_SPEED)
        return kelpie.WalkRequest(turn_deg=speed, kind=kelpie.WALK_TURNING)
    if abs(off_deg) < 60.0:
        request.forward = max(request.forward, CLOSING * math.cos(math.radians(off_deg)))
    if request.kind == kelpie.WALK:
        request.forward = min(request.forward, SPEED * max(0.2, math.cos(math.radians(off_deg))))
    request.turn_deg = clamp(times * request.turn_deg, -TURN_SPEED, TURN_SPEED)
    return request


def walk_at(world, point) -> kelpie.WalkRequest:
    """The walk to a point of the robot frame, by what is walked already."""
    rules, request = rulebook.of(world), approach(point, world.last_command.walk.kind)
    if request.kind == kelpie.WALK_TURNING and not rules.TURNS_TO_BALL:
        request.kind = kelpie.WALK
    return limited(request, heading(*point), rules.APPROACH_TURN)


def can_grab(ball, velocity, turn_lost) -> bool:
    """Alg 6.3: whether a ball (cm) with that velocity (cm a frame, of the robot frame) is between
    the paws in one of the next six frames."""
    x, y = ball
    vx, vy = velocity
    maximum = AHEAD if turn_lost > TURNED else AHEAD * AFTER_TURN
    for _ in range(PREDICTED if vx or vy else 1):
        if abs(x) < SIDE and 0.0 < y and math.hypot(x, y) < maximum:
            return True
        x, y, vx, vy = x + vx, y + vy, DRAG * vx, DRAG * vy
    return False


class Grab(Machine):
    NAME = 'grab'

    def __init__(self, memory):
        super().__init__(self.approach)
        self.memory = memory
        self.track = TrackBall(memory)
        self.inside_s = None    # since when the ball is believed between the paws
        self.begun_s = None     # when the rules' clock started, at the latest as it was asked for
        self.quick = False
        self.ran = False     # the motion has begun

    @property
    def committed(self) -> bool:
        """The motion was asked for: nobody should take the legs away now."""
        return self.state == self.grab

    @property
    def done(self) -> bool:
        return self.state == self.finished

    def step(self, world) -> kelpie.Command:
        self.approached, self.grabbed, self.hint = False, False, None
        return super().step(world)

    def approach(self, world):
        ball = (world.ball.relative.x, world.ball.relative.y)
        self.approached = True
        self.watch_paws(world, *ball)
        vx, vy = intercept.relative_velocity(world) if intercept.rolls(world.ball) else (0.0, 0.0)
        seen = world.ball.seconds_since_seen < SEEN_S
        if seen and can_grab(ball, (vx * FRAME_S, vy * FRAME_S), self.memory.turn_lost):
            self.quick = near(self.memory.chest, IR_NEAR)
            self.begun_s = world.time_s if self.inside_s is None else self.inside_s
            return self.enter(world, self.grab, None,
                              'ball {} cm ahead, {} cm aside; infrared of the chest {} cm',
                              ball[1], ball[0], self.memory.chest)
        if world.ball.distance < HINT_WITHIN:
            self.hint = hints.GRAB
        place = intercept.target(world)
        return kelpie.Command(walk=walk_at(world, place), head=self.track.step(world))

    def watch_paws(self, world, x, y):
        """A referee counts a ball as held that only lies there."""
        if abs(x) > PAWS_LATERAL or not PAWS_NEAR < y < PAWS_FAR:
            self.inside_s = None
        elif self.inside_s is None:
            self.inside_s = world.time_s

    def grab(self, world):
        """Asks until the motion runs, then waits for its end."""
        self.grabbed = True
        lifts = rulebook.of(world).LIFTS_HEAD
        motion = (kelpie.GRAB_LIFT if lifts else
                  kelpie.GRAB_QUICK if self.quick else kelpie.GRAB)
        running = world.motion.running in GRABS
        command = carry(forward=FORWARD)
        if lifts:
            command.head.head_pan_deg = clamp(world.ball.heading_deg, -MAX_PAN, MAX_PAN)
        if running:
            self.ran = True
        passed = self.since(world)
        if (self.ran and not running) or passed > (LONGEST_S if self.ran else START_S):
            return self.enter(world, self.finished, None, 'the motion took {} s', passed)
        command.motion = kelpie.NO_MOTION if self.ran else motion
        if self.hurries(world):
            command.motion = kelpie.GRAB_QUICK
        return command

    def hurries(self, world) -> bool:
        """Whether the motion that runs is to go on as the quick one: once the infrared says that
        the ball is close it counts two frames in one (Alg 6.4)."""
        running = world.motion.running
        return (rulebook.of(world).HURRIES_GRAB and running in (kelpie.GRAB, kelpie.GRAB_LIFT) and
                self.since(world) < HURRIES_S and near(self.memory.chest, IR_NEAR))

    def finished(self, world):
        self.grabbed = True
        return carry()
