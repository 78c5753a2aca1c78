# SPDX-License-Identifier: Apache-2.0
# The rules of the search for a lost ball, as functions of one frame's situation: which of the steps
# is next (thesis 2006 section 6.2.2 and figure 6.2), where the scan ends, how fast and with which
# head the robot spins. Keeps nothing. Frames are counted by situation/memory.py. Numbers without a
# source are ours.
import math

import kelpie
from lib.geom import clamp
from situation.infrared import near

LAST_SEEN_FRAMES = 4     # an unseen ball is still where it was seen
BELIEF_FRAMES = 26       # fewer unseen frames: the estimate tells where it is
HINT_FRAMES = 15         # a hint holds that long (facts-2005 section 7.1)
SCAN_FRAMES = 30         # 1 s
BACK_OFF_WITHIN = 40.0   # cm
LEFT_FRAMES = 60         # since a hint farther than that or so far off: the ball was sent away
LEFT_BEARING = 20.0      # deg
BACK_OFF_FRAMES = 45     # a wall behind, or a ball that rolls after us, must not hold it for ever
IR_NEAR = 12.0           # cm; the carpet, the head as far down as it looks, reads 14
LOW_NECK = -34.0         # deg; a neck that holds a ball is lower, and the carpet as near
IR_FRAMES = 66           # since the ball was close (scan threshold of facts-2005 section 7.1)
SPIN_TURN = 360.0        # deg by odometry; then somewhere else is looked
# Frames in which the image shows the place where the ball is believed, and no ball: it is not there
# (gps takes as many, BallFilterParams::missedFrames, to forget it faster).
MISSED_FRAMES = 5
BLOCKS = (kelpie.BLOCK, kelpie.BLOCK_LEFT, kelpie.BLOCK_RIGHT)

MAX_PAN = 88.0           # deg
SCAN_SDS = 2.0           # G37: standard deviations to either side of the ball
MIN_SCAN = 20.0          # deg; half the image is 28
MAX_SCAN = 90.0          # deg
SPIN_SPEED = 55.0        # deg/s, of thesis 2006 algorithm 6.2
SPIN_MORE = 1.1          # times as fast for a near ball; misprinted 0.9, G38
SPIN_NEAR = 20.0  # cm,
SPIN_FAR = 120.0  # cm


class Situation:
    """What the steps decide on. Counts are frames, lengths cm."""

    __slots__ = ('frame', 'lost', 'force_until', 'hint_frame', 'ir', 'close_lost', 'blocking',
                 'believed', 'distance', 'left', 'backed', 'scanned', 'reach', 'turned', 'unseen')

    def __init__(self, frame=0, lost=BELIEF_FRAMES, force_until=-1, hint_frame=None, ir=math.inf,
                 close_lost=10000, blocking=False, believed=False, distance=math.inf, left=False,
                 backed=0, scanned=0, reach=MAX_SCAN, turned=0.0, unseen=36):
        self.frame = frame
        self.lost = lost                # frames since vision saw the ball
        self.force_until = force_until  # the last frame of a forced look
        self.hint_frame = hint_frame    # when the hint was given
        self.ir = ir                    # filtered near distance of the head
        self.close_lost = close_lost    # frames since the ball was close
        self.blocking = blocking        # a block runs
        self.believed = believed        # gps has an estimate of the ball that no image refuted
        self.distance = distance        # to it
        self.left = left                # a skill reported that it went away
        self.backed = backed            # frames that it stepped back
        self.scanned = scanned          # frames that it scanned
        self.reach = reach              # deg of the pan that a scan would cover
        self.turned = turned            # deg that it spun
        self.unseen = unseen            # sectors around it that no image showed


def sent_away(hint, frame) -> bool:
    """Whether a hint (distance, heading, frame) says that the ball left the feet a moment ago."""
    return (hint is not None and frame - hint[2] < LEFT_FRAMES
            and (hint[0] > BACK_OFF_WITHIN or abs(hint[1]) > LEFT_BEARING))


def use_forced(now) -> bool:
    return now.frame <= now.force_until


def use_infrared(now) -> bool:
    return (now.lost > 0 and now.close_lost < IR_FRAMES and near(now.ir, IR_NEAR)
            and not now.blocking)


def use_hint(now) -> bool:
    return (now.lost > 0 and now.hint_frame is not None
            and now.frame - now.hint_frame <= HINT_FRAMES)


def use_last_seen(now) -> bool:
    return now.lost <= LAST_SEEN_FRAMES


def use_belief(now) -> bool:
    return now.believed and now.lost < BELIEF_FRAMES


def use_back_off(now) -> bool:
    return (now.believed and now.distance < BACK_OFF_WITHIN and not now.left
            and now.backed < BACK_OFF_FRAMES)


def use_scan(now) -> bool:
    return now.scanned < SCAN_FRAMES and now.reach > 0.0


def use_spin(now) -> bool:
    return now.turned < SPIN_TURN and now.unseen > 0


def use_roam(now) -> bool:
    return True


# Figure 6.2 from the top, and ours last: each step's name, condition, reason and deciding number.
CHAIN = (
    ('forced', use_forced, 'told to look there until frame {}', 'force_until'),
    ('infrared', use_infrared, 'something is {} cm before the nose', 'ir'),
    ('hint', use_hint, 'a hint of frame {} says where it comes out', 'hint_frame'),
    ('last_seen', use_last_seen, 'unseen for {} frames only', 'lost'),
    ('belief', use_belief, 'unseen for {} frames: where gps believes it', 'lost'),
    ('back_off', use_back_off, 'believed {} cm away: under the chin perhaps', 'distance'),
    ('scan', use_scan, 'unseen for {} frames: a scan', 'lost'),
    ('spin', use_spin, 'not in the scan after {} frames: once round', 'lost'),
    ('roam', use_roam, 'not around here after {} deg: look elsewhere', 'turned'))


def first_step(now) -> tuple:
    """(name, reason, number) of the first step of the chain whose condition holds."""
    for name, use, reason, number in CHAIN:
        if use(now):
            return name, reason, getattr(now, number)
    raise AssertionError('the last step of the chain always holds')


def scan_half_width(ball_sd, distance, heading_sd_deg) -> float:
    """Degrees that a scan goes to either side of the ball (G37, in place of the lost algorithm
    6.1), from the ball's standard deviation in cm at its distance and the robot's own."""
    seen_under = math.degrees(math.atan2(ball_sd, max(distance, 1.0)))
    return clamp(SCAN_SDS * (seen_under + heading_sd_deg), MIN_SCAN, MAX_SCAN)


def scan_limits(ball_heading, half_width) -> tuple[float, float]:
    """(min, max) of the pan; both the same where the head does not reach any of it."""
    return (clamp(ball_heading - half_width, -MAX_PAN, MAX_PAN),
            clamp(ball_heading + half_width, -MAX_PAN, MAX_PAN))


def spin_speed(distance, side) -> float:
    """deg/s; algorithm 6.2: a little faster for a near ball, since it is seen under more."""
    share = clamp((SPIN_FAR - distance) / (SPIN_FAR - SPIN_NEAR), 0.0, 1.0)
    return SPIN_SPEED * (1.0 + share * (SPIN_MORE - 1.0)) * side


def spin_head(distance, side) -> tuple[float, float, float]:
    """(pan, tilt, crane) in deg while spinning (section 6.2.2)."""
    return (45.0 * side, -10.0, 0.0) if distance > SPIN_FAR else (30.0 * side, -10.0, -10.0)
