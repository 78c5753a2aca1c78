# SPDX-License-Identifier: Apache-2.0
# Whether a shot is to be stopped with the body, and by which block (thesis 2006 section 4.3.1,
# checklist G14). Keeps in how many frames in a row the ball filter told of a shot: it is believed
# only then, since a false block costs 1.5 s on the ground. It fails against a shot that the filter
# tells of too late.
import kelpie
from lib.tune_goalie import Block as Tune
from situation.shot import Shot, coming

NAMES = {kelpie.BLOCK: 'wide', kelpie.BLOCK_LEFT: 'left', kelpie.BLOCK_RIGHT: 'right'}


def block_for(shot: Shot) -> int:
    """The block that meets a shot in time, or NO_MOTION: wide for one that comes straight, else to
    the side on which it would pass."""
    if not Tune.SOONEST <= shot.seconds <= Tune.LATEST or abs(shot.aside) > Tune.REACH:
        return kelpie.NO_MOTION
    if shot.speed < Tune.STAND_SPEED and abs(shot.aside) < stepped(shot.seconds):
        return kelpie.NO_MOTION
    if abs(shot.aside) <= Tune.CENTRE:
        return kelpie.BLOCK
    return kelpie.BLOCK_LEFT if shot.aside < 0.0 else kelpie.BLOCK_RIGHT


def stepped(seconds) -> float:
    """cm aside that a goalie on its feet covers of a ball that comes in that time."""
    return Tune.STAND + Tune.STEP * max(0.0, seconds - Tune.STEP_LATE)


class ShotWatch:
    def __init__(self, memory):
        self.memory = memory
        self.frames = 0
        self.run = 0      # frames in which the ball was seen, but for single ones
        self.shot = None
        self.was = None   # the ball's place on the field in the last frame

    def update(self, world):
        """To be called in every frame."""
        seen = world.ball.seconds_since_seen < Tune.SEEN
        self.shot = coming(world, Tune.BESIDE, Tune.SHORT, Tune.SPEED) if seen else None
        moved = self.moved(world)
        sure = self.shot is not None and self.shot.speed < Tune.FASTEST and self.steady() and moved
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
        return along > Tune.MOVED * self.shot.speed * world.elapsed_s

    def steady(self) -> bool:
        """Whether vision had the ball for some frames, one of them missing at most."""
        self.run = max(self.run, self.memory.ball_run) if self.memory.ball_lost < 2 else 0
        return self.run >= Tune.SEEN_FRAMES

    def block(self) -> int:
        """The block to be done now, or NO_MOTION."""
        believed = self.frames >= Tune.FRAMES
        return block_for(self.shot) if believed else kelpie.NO_MOTION
