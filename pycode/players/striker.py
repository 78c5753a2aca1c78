# SPDX-License-Identifier: Apache-2.0
# Alone against an empty goal: find the ball, walk to it, line up, strike, kick, and again. Keeps
# the state, where the goal is and when it was last looked for. Every state but search has an end in
# time; a skill that runs out of it steps back and starts over. Knows no other robots.
import kelpie
from lib.geom import heading
from lib.goal import NEVER_S, OpponentGoal
from lib.head import look_at, view
from lib.machine import Machine
from lib.tune import Approach, Goal, Kick, LineUp, Strike, Stuck, Watch
from skills.find_ball import FindBall
from skills.get_up import GetUp
from skills.go_to_ball import GoToBall
from skills.kick import Kick as KickForward
from skills.line_up import CircleBall, aim_error
from skills.strike import StepToKick
from skills.watch import Scan, Sweep, WatchBall

LOST_S = 1.5          # an unseen ball is believed that long
SEEN_AGAIN_S = 0.2    # a ball seen that recently is seen now


class Striker(Machine):
    def __init__(self):
        super().__init__(self.search)
        self.goal = OpponentGoal()
        self.watch = WatchBall()
        self.get_up = GetUp()
        self.swept_s = NEVER_S  # when the goal was last looked for

    def command(self, world) -> kelpie.Command:
        self.goal.update(world)
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.reset(world, 'play is halted', self.search)
            return self.idle(world)
        if self.get_up.needed(world):
            self.reset(world, 'has fallen', self.search)
            return kelpie.Command(motion=self.get_up.motion(world))
        return self.step(world)

    def idle(self, world) -> kelpie.Command:
        return kelpie.Command(head=Scan().head(world, world.time_s))

    # What several states do

    def lost(self, world) -> bool:
        return not world.ball.present or world.ball.seconds_since_seen > LOST_S

    def search_again(self, world, why='the ball is lost'):
        return self.reset(world, why, self.search)

    def give_up(self, world):
        return self.reset(world, self.state.__name__ + ' timed out', self.step_back)

    def track(self, world) -> kelpie.HeadRequest:
        ball = world.ball.relative
        return look_at(ball.x, ball.y, Watch.BALL_HEIGHT, world.stance)

    # States: each returns a Command, or None when it has entered another

    def search(self, world):
        if world.ball.present and world.ball.seconds_since_seen < Watch.FRESH:
            return self.enter(world, self.approach, GoToBall())
        if self.skill is None:
            self.skill = FindBall(world)
        return self.skill.command(world)

    def approach(self, world):
        if self.lost(world):
            return self.search_again(world)
        if self.timed_out(world, Approach.TIME):
            return self.give_up(world)
        if world.ball.distance < Approach.NEAR:
            return self.enter(world, self.line_up, CircleBall())
        walk = self.skill.walk(world, self.goal.where(world))
        return kelpie.Command(walk=walk, head=self.watch.head(world, self.goal))

    def line_up(self, world):
        if self.lost(world):
            return self.search_again(world)
        if world.ball.distance > LineUp.LEFT_BEHIND:
            return self.enter(world, self.approach, GoToBall())
        if not self.goal.seen(world) and world.time_s - self.swept_s > 2.0 * Goal.FRESH:
            return self.enter(world, self.look_for_goal, Sweep())
        if self.timed_out(world, LineUp.TIME):
            return self.give_up(world)
        goal_point = self.goal.where(world)
        if self.aligned(world, goal_point):
            return self.enter(world, self.strike, StepToKick())
        return kelpie.Command(walk=self.skill.walk(world, goal_point),
                              head=self.watch.head(world, self.goal))

    def aligned(self, world, goal_point) -> bool:
        ball = (world.ball.relative.x, world.ball.relative.y)
        return (goal_point is not None and abs(aim_error(ball, goal_point)) < LineUp.AIMED and
                abs(heading(*ball)) < LineUp.FACED)

    def look_for_goal(self, world):
        """Stands still for one sweep of the head: the shot is worth knowing where the goal is."""
        seen = self.goal.seen(world) and self.goal.seen_s > self.entered_s
        if seen or self.timed_out(world, Goal.SWEEP):
            self.swept_s = world.time_s
            return self.enter(world, self.regain)
        return kelpie.Command(head=self.skill.head(world, self.since(world)))

    def regain(self, world):
        """After a look elsewhere the head needs a moment to find the ball again."""
        if world.ball.present and world.ball.seconds_since_seen < Watch.FRESH:
            return self.enter(world, self.line_up, CircleBall())
        if self.timed_out(world, Goal.REGAIN) or not world.ball.present:
            return self.search_again(world)
        return kelpie.Command(head=self.track(world))

    def strike(self, world):
        if self.lost(world):
            return self.search_again(world)
        if self.timed_out(world, Strike.TIME):
            return self.give_up(world)
        goal_point = self.goal.where(world)
        if self.skill.can_kick(world, goal_point):
            return self.enter(world, self.kick, KickForward(world))
        if self.skill.out_of_reach(world, goal_point):
            return self.enter(world, self.line_up, CircleBall())
        return kelpie.Command(walk=self.skill.walk(world, goal_point), head=self.track(world))

    def kick(self, world):
        motion = self.skill.motion(world)
        if self.skill.done(world):
            return self.enter(world, self.look_after)
        return kelpie.Command(head=view(0.0, Kick.LOOK_DOWN, world.stance), motion=motion)

    def look_after(self, world):
        """The ball rolls away ahead: look there first."""
        if world.ball.present and world.ball.seconds_since_seen < SEEN_AGAIN_S:
            return self.enter(world, self.approach, GoToBall())
        if self.timed_out(world, Kick.LOOK_AFTER):
            return self.search_again(world, 'the ball is gone after the kick')
        return kelpie.Command(head=view(0.0, Kick.LOOK_AHEAD, world.stance))

    def step_back(self, world):
        if self.timed_out(world, Stuck.STEP_BACK):
            return self.enter(world, self.search)
        return kelpie.Command(walk=kelpie.WalkRequest(forward=Stuck.SPEED),
                              head=self.track(world))
