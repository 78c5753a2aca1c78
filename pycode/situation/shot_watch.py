# SPDX-License-Identifier: Apache-2.0
# Whether a shot is to be stopped with the body, and by which block (thesis 2006 section 4.3.1,
# checklist G14). Keeps in how many frames in a row the ball filter reported a shot: it is believed
# only then, since a false block costs 1.5 s on the ground. It fails against a shot that the filter
# tells of too late.
import kelpie
from lib import rulebook
from situation.shot import Shot, coming

CONSTANTS = kelpie.constants.shot_watch  # behaviour/constants.toml: defaults and ranges
# Facts-2005 section 7.2, in cm/s and s; what differs says why.
SPEED = CONSTANTS.speed  # cm/s. A slower ball is walked to, it leaves the time;
SPEED_2005 = 12.0        # cm/s
SOONEST = 0.1            # s, 3 frames; later than that no block is in time
LATEST = 0.8             # s, 27 frames; before it, walk
CENTRE = 9.0             # cm to the side, to which the wide block is right
REACH = 36.0             # cm; block_left covers 32 (docs/physical-body.md) and a radius
REACH_2005 = 30.0        # cm
STAND_SPEED = CONSTANTS.stand_speed  # cm/s; up to there a ball is stopped standing, if that is
                         # enough: on its feet the goalie clears before the attacker comes, but a
                         # block takes 1.7 s. Of 96 balls 3 went in, 7 when every one was blocked
STAND = CONSTANTS.stand  # cm covered by who stands,
STEP = CONSTANTS.step  # cm/s of a side step,
STEP_LATE = 0.25         # s until it begins
BESIDE = 6.0             # cm beside the mouth: the velocity is off by some degrees
SHORT = CONSTANTS.falls_short  # cm; a ball that would stop that short of the line may still go in
SEEN = 0.12              # s; a ball unseen for longer is not judged
FRAMES = 2               # in a row that say so
FASTEST = 240.0          # cm/s; kicks go 2.2 m, which takes 190. What is faster was lost and found
                         # elsewhere:
SEEN_FRAMES = 4          # a ball is judged when seen that often in a row,
MOVED = 0.4              # and has gone that share of the way that its velocity says, in each frame

NAMES = {kelpie.BLOCK: 'wide', kelpie.BLOCK_LEFT: 'left', kelpie.BLOCK_RIGHT: 'right'}


def block_for(shot: Shot, late=True) -> int:
    """The block that meets a shot in time, or NO_MOTION: wide for one that comes straight, else to
    the side on which it would pass. `late`: none for what is stopped standing."""
    if not SOONEST <= shot.seconds <= LATEST or abs(shot.lateral) > (REACH if late else REACH_2005):
        return kelpie.NO_MOTION
    if late and shot.speed < STAND_SPEED and abs(shot.lateral) < stepped(shot.seconds):
        return kelpie.NO_MOTION
    if abs(shot.lateral) <= CENTRE:
        return kelpie.BLOCK
    return kelpie.BLOCK_LEFT if shot.lateral < 0.0 else kelpie.BLOCK_RIGHT


def stepped(seconds) -> float:
    """cm to the side that a goalie on its feet covers of a ball that comes in that time."""
    return STAND + STEP * max(0.0, seconds - STEP_LATE)


class ShotWatch:
    def __init__(self, memory):
        self.memory = memory
        self.frames = 0
        self.run = 0      # frames in which the ball was seen, but for single ones
        self.shot = None
        self.late = True  # the rule of this match
        self.was = None   # the ball's place on the field in the last frame

    def update(self, world):
        """To be called in every frame."""
        seen = world.ball.seconds_since_seen < SEEN
        self.late = rulebook.of(world).BLOCKS_LATE
        slowest = SPEED if self.late else SPEED_2005
        self.shot = coming(world, BESIDE, SHORT, slowest) if seen else None
        moved = self.moved(world)
        sure = self.shot is not None and self.shot.speed < FASTEST and self.steady() and moved
        self.frames = self.frames + 1 if sure else 0

    def moved(self, world) -> bool:
        """Whether the ball is believed to have gone on since the last frame nearly as fast as its
        velocity says. One bad sighting makes a velocity, but no way in the frames after it."""
        ball, was = world.ball, self.was
        self.was = (ball.position.x, ball.position.y)
        if was is None or self.shot is None:
            return False
        dx, dy = ball.position.x - was[0], ball.position.y - was[1]
        along = (dx * ball.velocity.x + dy * ball.velocity.y) / self.shot.speed
        return along > MOVED * self.shot.speed * world.elapsed_s

    def steady(self) -> bool:
        """Whether vision had the ball for some frames, one of them missing at most."""
        self.run = max(self.run, self.memory.ball_run) if self.memory.ball_lost < 2 else 0
        return self.run >= SEEN_FRAMES

    def block(self) -> int:
        """The block to be done now, or NO_MOTION."""
        believed = self.frames >= FRAMES
        return block_for(self.shot, self.late) if believed else kelpie.NO_MOTION
