# SPDX-License-Identifier: Apache-2.0
# Gets the ball between itself and the goal and kicks it ahead from where it lies: what is played in
# place of a grab when grabbing is switched off. Keeps the state; where the goal is, and when it was
# looked for, its player keeps, since another leaf may come between. The goal is looked for once in
# a while before the robot lines up. Slow: it circles the ball.
import kelpie
from arbiter.machine import Machine
from lib.geom import heading
from lib.head import look_at, view
from situation.goal import Goal
from situation.memory import own_goal_at
from skills.ball.go_to_ball import Approach, GoToBall
from skills.ball.line_up import CircleBall, LineUp, aim_error
from skills.ball.strike import StepToKick, Strike
from skills.head.watch import Sweep, Watch, WatchBall
from skills.motion.kick import Kick

LOOK_DOWN = 20.0    # deg of the view below the horizontal while kicking,
LOOK_AHEAD = 12.0   # and after it


class LineUpKick(Machine):
    NAME = 'line_up_kick'

    def __init__(self, memory, goal):
        """`goal`: the player's OpponentGoal, which the player keeps up to date."""
        super().__init__(self.approach, GoToBall())
        self.memory = memory
        self.goal = goal
        self.watch = WatchBall()

    @property
    def committed(self) -> bool:
        return self.state in (self.strike, self.kick, self.look_for_goal, self.regain)

    @property
    def done(self) -> bool:
        return self.state == self.ended

    def track(self, world) -> kelpie.HeadRequest:
        ball = world.ball.relative
        return look_at(ball.x, ball.y, Watch.BALL_HEIGHT, world.stance)

    def approach(self, world):
        if self.timed_out(world, Approach.TIME):
            return self.enter(world, self.ended, None, 'the approach took too long')
        if world.ball.distance < Approach.NEAR:
            return self.enter(world, self.line_up, CircleBall(), 'ball {} cm away',
                              world.ball.distance)
        walk = self.skill.step(world, self.goal.where(world))
        return kelpie.Command(walk=walk, head=self.watch.step(world, self.goal))

    def line_up(self, world):
        goal_point = self.goal.where(world)
        if world.ball.distance > LineUp.LEFT_BEHIND:
            return self.enter(world, self.approach, GoToBall(), 'the ball rolled {} cm away',
                              world.ball.distance)
        if not self.goal.seen(world) and world.time_s - self.goal.looked_s > 2.0 * Goal.FRESH:
            return self.enter(world, self.look_for_goal, Sweep(), 'where is the goal?')
        if self.timed_out(world, LineUp.TIME):
            return self.enter(world, self.ended, None, 'circled too long')
        if self.aligned(world, goal_point):
            return self.enter(world, self.strike, StepToKick(), 'ball and goal are in line')
        return kelpie.Command(walk=self.skill.step(world, goal_point),
                              head=self.watch.step(world, self.goal))

    def aligned(self, world, goal_point) -> bool:
        """Never where strike() would send it back at once: a ball unseen for long, for example."""
        ball = (world.ball.relative.x, world.ball.relative.y)
        return (goal_point is not None and abs(aim_error(ball, goal_point)) < LineUp.AIMED and
                abs(heading(*ball)) < LineUp.FACED and
                not StepToKick().out_of_reach(world, goal_point))

    def look_for_goal(self, world):
        """Stands still for one sweep of the head: it pays to know where the goal is."""
        seen = self.goal.seen(world) and self.goal.seen_s > self.entered_s
        if seen or self.timed_out(world, Goal.SWEEP):
            self.goal.looked(world)
            return self.enter(world, self.regain, None, 'looked for the goal')
        return kelpie.Command(head=self.skill.step(world, self.since(world)))

    def regain(self, world):
        """After a look elsewhere the head needs a moment to find the ball again."""
        seen = world.ball.present and world.ball.seconds_since_seen < Watch.FRESH
        if seen or self.timed_out(world, Goal.REGAIN):
            return self.enter(world, self.line_up, CircleBall(),
                              'ball unseen for {} s', world.ball.seconds_since_seen)
        return kelpie.Command(head=self.track(world))

    def strike(self, world):
        goal_point = self.goal.where(world)
        if self.timed_out(world, Strike.TIME):
            return self.enter(world, self.ended, None, 'the last steps took too long')
        if self.skill.can_kick(world, goal_point) and not own_goal_at(self.memory, 0.0):
            return self.enter(world, self.kick, Kick(world, kelpie.KICK_FORWARD),
                              'ball {} cm ahead', world.ball.relative.y)
        if self.skill.out_of_reach(world, goal_point):
            return self.enter(world, self.line_up, CircleBall(), 'small steps help no more')
        return kelpie.Command(walk=self.skill.step(world, goal_point), head=self.track(world))

    def kick(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            return self.enter(world, self.ended, None, 'kicked')
        head = view(0.0, LOOK_DOWN, world.stance)
        return kelpie.Command(head=head, motion=motion)

    def ended(self, world):
        return kelpie.Command(head=view(0.0, LOOK_AHEAD, world.stance))
