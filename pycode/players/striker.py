# SPDX-License-Identifier: Apache-2.0
# Alone against an empty goal: find the ball, walk to it, line up, strike, kick, and again. Every
# state has an end in time; one that runs out steps back and starts over.
import kelpie
from lib.geom import heading
from lib.goal import OpponentGoal
from lib.head import look_at, view
from lib.tune import Approach, Goal, LineUp, Stuck, Watch
from skills.find_ball import FindBall
from skills.go_to_ball import GoToBall
from skills.kick import KickForward
from skills.line_up import CircleBall, aim_error
from skills.strike import StepToKick
from skills.watch import Scan, Sweep, WatchBall

LOST_S = 1.5  # an unseen ball is believed that long


class Striker:
    def __init__(self):
        self.goal = OpponentGoal()
        self.watch = WatchBall()
        self.state = self.search
        self.skill = None
        self.since_s = 0.0
        self.swept_s = -1e9  # when the goal was last looked for

    def tick(self, world):
        self.goal.tick(world)
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.enter(self.search, None, world)
            return kelpie.Command(head=Scan().tick(world, world.time_s))
        # A state answers with a Command or, having entered another state, with nothing. Four in one
        # frame is more than any sane chain, and two that disagree must not bounce for ever.
        for _ in range(4):
            command = self.state(world)
            if command is not None:
                return command
        return kelpie.Command(head=Scan().tick(world, world.time_s))

    def enter(self, state, skill, world):
        self.state = state
        self.skill = skill
        self.since_s = world.time_s

    def lost(self, world):
        return not world.ball.present or world.ball.seconds_since_seen > LOST_S

    def start_over(self, world):
        self.enter(self.step_back, None, world)

    def track(self, world):
        ball = world.ball.relative
        return look_at(ball.x, ball.y, Watch.BALL_HEIGHT, world.stance)

    def search(self, world):
        seen = world.ball.present and world.ball.seconds_since_seen < Watch.FRESH
        if seen:
            return self.enter(self.approach, GoToBall(world), world)
        if self.skill is None:
            self.skill = FindBall(world)
        return self.skill.tick(world)

    def approach(self, world):
        if self.lost(world):
            return self.enter(self.search, None, world)
        if self.skill.timed_out(world):
            return self.start_over(world)
        if world.ball.distance < Approach.NEAR:
            return self.enter(self.line_up, CircleBall(world), world)
        walk = self.skill.tick(world, self.goal.where(world))
        return kelpie.Command(walk=walk, head=self.watch.tick(world, self.goal))

    def line_up(self, world):
        if self.lost(world):
            return self.enter(self.search, None, world)
        if world.ball.distance > LineUp.LEFT_BEHIND:
            return self.enter(self.approach, GoToBall(world), world)
        goal = self.goal.where(world)
        if not self.goal.seen(world) and world.time_s - self.swept_s > 2.0 * Goal.FRESH:
            return self.enter(self.look_for_goal, Sweep(), world)
        if self.skill.timed_out(world):
            return self.start_over(world)
        ball = (world.ball.relative.x, world.ball.relative.y)
        if goal is not None and self.aligned(ball, goal):
            return self.enter(self.strike, StepToKick(world), world)
        return kelpie.Command(walk=self.skill.tick(world, goal), head=self.track(world))

    def aligned(self, ball, goal):
        return abs(aim_error(ball, goal)) < LineUp.AIMED and abs(heading(*ball)) < LineUp.FACED

    def look_for_goal(self, world):
        """Stands still for one sweep of the head: the shot is worth knowing where the goal is."""
        passed = world.time_s - self.since_s
        if self.goal.seen(world) and self.goal.seen_s > self.since_s or passed > Goal.SWEEP:
            self.swept_s = world.time_s
            return self.enter(self.regain, None, world)
        return kelpie.Command(head=self.skill.tick(world, passed))

    def regain(self, world):
        """After a look elsewhere the head needs a moment to find the ball again."""
        passed = world.time_s - self.since_s
        if world.ball.present and world.ball.seconds_since_seen < Watch.FRESH:
            return self.enter(self.line_up, CircleBall(world), world)
        if passed > 1.0 or not world.ball.present:
            return self.enter(self.search, None, world)
        return kelpie.Command(head=self.track(world))

    def strike(self, world):
        if self.lost(world):
            return self.enter(self.search, None, world)
        if self.skill.timed_out(world):
            return self.start_over(world)
        goal = self.goal.where(world)
        if self.skill.can_kick(world, goal):
            return self.enter(self.kick, KickForward(world), world)
        if self.skill.lost(world, goal):
            return self.enter(self.line_up, CircleBall(world), world)
        return kelpie.Command(walk=self.skill.tick(world, goal), head=self.track(world))

    def kick(self, world):
        motion = self.skill.tick(world)
        if self.skill.done(world):
            return self.enter(self.look_after, None, world)
        return kelpie.Command(head=view(0.0, 20.0, world.stance), motion=motion)

    def look_after(self, world):
        """The ball rolls away ahead: look there first."""
        if world.ball.present and world.ball.seconds_since_seen < 0.2:
            return self.enter(self.approach, GoToBall(world), world)
        if world.time_s - self.since_s > 1.0:
            return self.enter(self.search, None, world)
        return kelpie.Command(head=view(0.0, 12.0, world.stance))

    def step_back(self, world):
        if world.time_s - self.since_s > Stuck.STEP_BACK:
            return self.enter(self.search, None, world)
        return kelpie.Command(walk=kelpie.WalkRequest(forward=Stuck.SPEED),
                              head=self.track(world))
