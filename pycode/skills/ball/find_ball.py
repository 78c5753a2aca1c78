# SPDX-License-Identifier: Apache-2.0
# Looks for a lost ball by a chain of eight steps (sFindBall, thesis 2006 section 6.2.2, figure 6.2)
# and a ninth of ours, a walk to the other half; in every frame the first whose condition holds
# (skills/ball/lost_ball.py) says what legs and head do. Keeps what is forced or hinted, carried
# along by odometry, how long it stepped back, scanned and spun, what it has looked at, and the side
# on which the ball was last believed. Has no end: the player leaves it when the ball is seen. Knows
# no obstacles.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook
from lib.geom import Point, clamp, heading, moved, polar
from lib.steer import aim_at, towards
from situation.memory import NEVER, Memory
from skills.ball import lost_ball
from skills.ball.doubt import Doubt
from skills.ball.explored import Explored
from skills.ball.lost_ball import MAX_SCAN, Situation, first_step, scan_half_width, scan_limits
from skills.ball.spin_for_ball import SpinForBall
from skills.head.scan_for_ball import ScanForBall, head_params
from skills.head.track_ball import TrackBall, believed
from skills.walk.roam import Roam

FRAMES_PER_S = 30.0  # 1/s
FORCED_AT = 120.0      # cm, where a look in a direction is aimed at
TURN_BEYOND = 45.0     # deg; a forced look that far off needs the body
BACK_SPEED = -50.0     # cm/s, of the walk back (docs/physical-body.md)
NEAR = 25.0            # cm; nearer to the belief the robot would push the ball
INFRARED_HEAD = (0.0, -10.0, -20.0)  # pan, tilt, crane
BREAK_PAN = 30.0       # deg back against a spin that went past the ball (G36)
ONE_SIDE = 8.0         # deg
TAKEN_S = 0.1  # s
SPIN_BREAK = 15        # frames for which a spin is recent (facts-2005 section 7.2)


def remembered(world) -> Memory:
    """A memory of its own, for who has none: the ball was lost when gps saw it last."""
    if not world.ball.present:
        return Memory()
    return Memory(min(NEVER, round(world.ball.seconds_since_seen * FRAMES_PER_S)))


def side_of(world, before) -> float:
    """The side on which the ball is believed, +1 left; as before when nobody knows, or when it is
    straight ahead and noise would decide."""
    off_deg = world.ball.heading_deg
    if not world.ball.present or abs(off_deg) < ONE_SIDE:
        return before
    return 1.0 if off_deg > 0.0 else -1.0


def taken(world) -> bool:
    """Whether gps takes what vision saw for the ball: one sighting elsewhere may be a mistake."""
    return world.ball.present and world.ball.seconds_since_seen < TAKEN_S


def ball_sd(covariance) -> float:
    """Standard deviation (cm) of a 2 x 2 covariance along its widest axis."""
    xx, xy, yy = covariance[0], covariance[1], covariance[3]
    return math.sqrt(max(0.0, 0.5 * (xx + yy) + math.hypot(0.5 * (xx - yy), xy)))


class FindBall(Machine):
    NAME = 'find_ball'

    def __init__(self, world, memory=None):
        super().__init__(self.last_seen)
        self.own_memory = memory is None
        self.memory = remembered(world) if memory is None else memory
        self.track = TrackBall(self.memory)
        self.force_until = -1          # the last frame of a forced look
        self.forced_point = None       # of the robot frame; None: where the ball is believed
        self.hint_frame = None         # of the hint that is followed
        self.hint_point = None         # of the robot frame
        self.still = None              # head joints while it does not move
        self.side = side_of(world, 1.0)
        # Whoever lost it has looked for it where it is believed since it was seen last.
        self.doubt = Doubt(max(0, self.memory.ball_lost - lost_ball.LAST_SEEN_FRAMES))
        self.hint_doubt = Doubt()
        self.roaming = Roam(world)
        self.restart()

    def restart(self):
        """The ball was seen or the robot is somewhere else: nothing here was looked at yet."""
        self.backed = self.scanned = 0
        self.explored = Explored()
        self.scan_head = ScanForBall(self.side)
        self.spinning = SpinForBall(self.memory, self.side)

    def force(self, heading_deg, until_frame) -> None:
        """Looks in a direction until that frame of the memory, after a kick for example; with None
        walks to where the ball is believed and looks there."""
        self.force_until = until_frame
        self.forced_point = None if heading_deg is None else polar(FORCED_AT, heading_deg)

    def step(self, world) -> kelpie.Command:
        self.carry(world)
        step, reason, number = first_step(self.situation(world))
        if rulebook.only_spins(world):
            step, reason, number = 'spin', 'told to spin only, unseen for {} frames', number
        if self.entered_s is None or self.state.__name__ != step:
            self.enter(world, getattr(self, step), None, reason, number)
        return super().step(world)

    def carry(self, world):
        """Takes one frame's odometry and percepts."""
        if self.own_memory:
            self.memory.update(world)
        if self.believes(world):
            self.side = side_of(world, self.side)
        if self.forced_point is not None:
            self.forced_point = moved(*self.forced_point, world.odometry)
        if self.hint_point is not None:
            self.hint_point = moved(*self.hint_point, world.odometry)
        hint = self.memory.hint
        if hint is not None and hint[2] != self.hint_frame:
            self.hint_point, self.hint_frame = polar(hint[0], hint[1]), hint[2]
            self.hint_doubt = Doubt()
        self.doubt.update(world, believed(world) if world.ball.present else None)
        self.hint_doubt.update(world, self.hint_point)
        if self.memory.ball_lost == 0 and taken(world):
            self.restart()
        self.explored.update(world)

    def situation(self, world) -> Situation:
        memory = self.memory
        low, high = self.limits(world)
        head_low = world.head.neck_tilt_deg < lost_ball.LOW_NECK
        known = self.forced_point is not None or world.ball.present
        now = Situation(frame=memory.frame, lost=memory.ball_lost,
                        force_until=self.force_until if known else -1, hint_frame=self.hint_frame,
                        ir=math.inf if head_low else memory.ir, close_lost=memory.close_lost,
                        blocking=world.motion.running in lost_ball.BLOCKS,
                        believed=self.believes(world), distance=self.away(world),
                        scanned=self.scanned, reach=high - low)
        self.add_ours(world, now)
        return now

    def add_ours(self, world, now):
        """What the thesis does not ask."""
        rules, memory = rulebook.of(world), self.memory
        if rules.BACKS_OFF_BRIEFLY:
            now.left, now.backed = lost_ball.sent_away(memory.hint, memory.frame), self.backed
        if rules.EXPLORES:
            now.turned, now.unseen = self.spinning.turned, self.explored.unseen
            if self.hint_doubt.refuted:
                now.hint_frame = None

    def believes(self, world) -> bool:
        refuted = self.doubt.refuted and rulebook.of(world).EXPLORES
        return world.ball.present and not refuted

    def away(self, world) -> float:
        return world.ball.distance if self.believes(world) else math.inf

    def limits(self, world) -> tuple[float, float]:
        """Pans of the scan: all that the head reaches without a belief."""
        ball = world.ball
        if not self.believes(world):
            return scan_limits(0.0, MAX_SCAN)
        half = scan_half_width(ball_sd(ball.covariance), ball.distance, world.heading_sd_deg)
        return scan_limits(ball.heading_deg, half)

    # The steps, in the order of the chain

    def forced(self, world) -> kelpie.Command:
        if self.forced_point is None:
            return self.go_and_look(believed(world))
        turn = towards(self.forced_point).turn_deg
        walk = kelpie.WalkRequest(
            turn_deg=turn if abs(heading(*self.forced_point)) > TURN_BEYOND else 0.0)
        return kelpie.Command(walk=walk, head=aim_at(*self.forced_point))

    def infrared(self, world) -> kelpie.Command:
        return kelpie.Command(walk=towards(believed(world)), head=head_params(*INFRARED_HEAD))

    def hint(self, world) -> kelpie.Command:
        return self.go_and_look(self.hint_point)

    def last_seen(self, world) -> kelpie.Command:
        """The head waits, but for a look back against a spin that went past the ball."""
        if self.memory.ball_lost == 0:
            self.still = None
            return kelpie.Command(walk=towards(believed(world), NEAR), head=self.track.step(world))
        if self.still is None:
            self.still = self.where_to_wait(world.head)
        return kelpie.Command(walk=towards(believed(world), NEAR),
                              head=kelpie.HeadRequest(**self.still))

    def where_to_wait(self, head):
        pan = head.head_pan_deg
        if self.memory.spin_lost < SPIN_BREAK:
            pan = clamp(pan - BREAK_PAN * self.memory.spin_side, -lost_ball.MAX_PAN,
                        lost_ball.MAX_PAN)
        return {'neck_tilt_deg': head.neck_tilt_deg, 'head_pan_deg': pan,
                'head_nod_deg': head.head_nod_deg}

    def belief(self, world) -> kelpie.Command:
        return self.go_and_look(believed(world))

    def back_off(self, world) -> kelpie.Command:
        self.backed += 1
        low, high = self.limits(world)
        walk = kelpie.WalkRequest(forward=BACK_SPEED, kind=kelpie.WALK_BACK)
        return kelpie.Command(walk=walk, head=self.scan_head.step(world, (low, high, True)))

    def scan(self, world) -> kelpie.Command:
        """Between the pans that belief and pose leave open."""
        knows = self.believes(world) or not rulebook.of(world).EXPLORES
        if self.scanned == 0:
            self.scan_head = ScanForBall(self.side if knows else -self.side)
        self.scanned += 1
        if not knows:
            return self.scan_around(world)
        return kelpie.Command(head=self.scan_head.step(world, (*self.limits(world), False)))

    def scan_around(self, world) -> kelpie.Command:
        """Without a belief the head goes to one side first, and then to the other while the body
        turns there, too: what the spin has to show afterwards is less."""
        head = self.scan_head.step(world)
        if self.scan_head.rows == 2:
            self.scanned = lost_ball.SCAN_FRAMES  # both sides were shown
        turns = self.scan_head.side == self.side
        times = rulebook.of(world).SPIN_TIMES
        turn = times * lost_ball.spin_speed(math.inf, self.side) if turns else 0.0
        return kelpie.Command(head=head, walk=kelpie.WalkRequest(turn_deg=turn))

    def spin(self, world) -> kelpie.Command:
        rules, only = rulebook.of(world), rulebook.only_spins(world)
        if self.spinning.turned == 0.0:
            self.spinning = SpinForBall(self.memory, self.side, 1.0 if only else rules.SPIN_TIMES)
        explores = rules.EXPLORES and not only
        unseen = self.explored.next_unseen(self.spinning.side) if explores else 0.0
        return self.spinning.step(world, (self.away(world), unseen))

    def roam(self, world) -> kelpie.Command:
        return self.roaming.step(world)

    def go_and_look(self, point: Point) -> kelpie.Command:
        return kelpie.Command(walk=towards(point, NEAR), head=aim_at(*point))
