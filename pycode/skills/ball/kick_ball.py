# SPDX-License-Identifier: Apache-2.0
# Walks up to a ball that lies free until it is where a kick strikes best, and kicks without a grab
# (leaves UPenn_Kick and Head_Kick of thesis 2006 section 5.4). Keeps the state and the motion. The
# ball's place is predicted for the moment the motion begins; a ball that the chin hides is where
# gps believes it. It does not turn to the goal: the decision tree chose the kick for how it stands.
import kelpie
from arbiter.machine import Machine
from lib import intercept, kick_table
from lib.geom import clamp
from situation.memory import own_goal_at
from skills.ball.grab import walk_at
from skills.head.track_ball import TrackBall
from skills.motion.kick import Kick

AHEAD_HINT = 50.0, 0.0  # cm, deg: where a kick that table 6.1 does not have sends it

LATENCY = 0.16         # s until the motion begins, in which the robot walks on
NEAR_AHEAD = 1.8  # cm,
NEAR_SIDE = 2.2  # cm
CLOSE = 30.0           # cm: from here on in steps, to both axes at once
GAIN = 2.6             # cm/s per cm
SPEED = 24.0  # cm/s,
SIDE_SPEED = 16.0  # cm/s
TOO_NEAR = 4.0         # cm nearer than the place: step back
LONGEST = 7.0          # s for the approach


class KickBall(Machine):
    NAME = 'kick_ball'

    def __init__(self, memory, which):
        super().__init__(self.walk_up)
        self.memory = memory
        self.which = which
        self.track = TrackBall(memory)

    @property
    def committed(self) -> bool:
        return self.state == self.kick

    @property
    def done(self) -> bool:
        return self.state == self.ended

    def walk_up(self, world):
        x, y = world.ball.relative.x, world.ball.relative.y
        ahead, left = kelpie.KICKS[self.which].place
        off_ahead, off_left = self.off(world, x, y)
        near = abs(off_ahead) < NEAR_AHEAD and abs(off_left) < NEAR_SIDE
        if near and own_goal_at(self.memory, kick_table.way(self.which, False)):
            return self.enter(world, self.ended, None, 'the own goal is seen where it would go')
        if near:
            return self.enter(world, self.kick, Kick(world, self.which),
                              'ball {} cm ahead, {} cm aside', y, x)
        if self.timed_out(world, LONGEST):
            return self.enter(world, self.ended, None, 'no place to kick from in time')
        head = self.track.step(world)
        if world.ball.distance > CLOSE:
            place = intercept.target(world)
            place = place[0] + left, place[1]
            return kelpie.Command(walk=walk_at(world, place), head=head)
        return kelpie.Command(walk=self.steps(y - ahead, -x - left), head=head)

    def off(self, world, x, y):
        """How far (ahead, left) the ball will be off the kick's place when the motion begins."""
        ahead, left = kelpie.KICKS[self.which].place
        step, seconds = world.odometry, max(world.elapsed_s, 0.02)
        walked = step.forward / seconds * LATENCY, step.left / seconds * LATENCY
        vx, vy = intercept.relative_velocity(world) if intercept.rolls(world.ball) else (0.0, 0.0)
        return (y + vy * LATENCY - walked[0] - ahead, -x - vx * LATENCY - walked[1] - left)

    def steps(self, ahead, left) -> kelpie.WalkRequest:
        """To the place of both axes: sideways first while the ball would be run over."""
        forward = clamp(GAIN * ahead, -SPEED, SPEED)
        if abs(left) > 2.0 * NEAR_SIDE and ahead < TOO_NEAR:
            forward = min(forward, 0.0)
        side = clamp(GAIN * left, -SIDE_SPEED, SIDE_SPEED)
        return kelpie.WalkRequest(forward=forward, left=side)

    def kick(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            self.hint = kelpie.KICKS[self.which].hint or AHEAD_HINT
            return self.enter(world, self.ended, None, 'kicked')
        return kelpie.Command(head=self.track.step(world), motion=motion)

    def ended(self, world):
        return kelpie.Command(head=self.track.step(world))
