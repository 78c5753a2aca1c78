# SPDX-License-Identifier: Apache-2.0
# The goalie of 2004 (thesis 2004 section 4.2): stands where the line from the ball to the goal's
# middle crosses an ellipse around the mouth, lazily; attacks a ball in its box or at its nose, by a
# swipe of a foreleg as the final code did or by the paw kick of the first version; keeps its legs
# off the wall beside the goal. Keeps the state and its head. It does not block, so hard shots into
# a gap go in, and it looks at nobody but the ball. Its thesis lets it out of the box; the rule of
# 2006 holds for it, too (checklist K07).
import kelpie
from arbiter.machine import Machine
from lib.goalie_places import beyond_box, central_place, ellipse_place, off_rear_wall
from lib.tune_goalie import Attack, GuardEllipse, Paw
from players.halted import Halted
from situation.memory import Memory
from skills.ball.attack_ball import AttackBall
from skills.ball.clear_ball import clearing_kick
from skills.ball.paw_kick import PawKick
from skills.head.ellipse_head import EllipseHead
from skills.head.goalie_head import seen
from skills.motion.get_up import GetUp
from skills.motion.kick import Kick
from skills.walk.guard_goal import GuardGoal


def attack_due(world) -> bool:
    """Whether the ball of gps is in the box or the seen one at the nose."""
    if not world.ball.present:
        return False
    in_box = beyond_box(world.field, ball_of(world)) == 0.0
    near = world.percepts.ball.present and world.percepts.ball.distance < Paw.VISUAL
    return in_box or near


def attack_failed(world) -> tuple | None:
    """Why an attack is broken off, with a number; None if it goes on."""
    away = beyond_box(world.field, ball_of(world))
    percept = world.percepts.ball
    if away > Attack.LEAVE:
        return 'the ball is {} cm beyond the box', away
    if percept.present and abs(percept.heading_deg) > Paw.ASIDE:
        return 'the ball is seen {} deg aside', percept.heading_deg
    if not seen(world, Attack.UNSEEN):
        return 'the ball is unseen for {} s', world.ball.seconds_since_seen
    return None


def ball_of(world):
    return world.ball.position.x, world.ball.position.y


class EllipseGoalie(Machine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'ellipse_goalie'

    def __init__(self, paw=False):
        super().__init__(self.guard, GuardGoal(GuardEllipse))
        self.paw = paw   # attack by the paw kick of the first version
        self.memory = Memory()
        self.eyes = EllipseHead(self.memory)
        self.get_up = GetUp()
        self.halted = Halted(self.memory, self.get_up)

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        command = self.decide(world)
        forward, left = off_rear_wall(world.field, world.pose, command.walk.forward,
                                      command.walk.left)
        command.walk.forward, command.walk.left = forward, left
        command.team.role = kelpie.NO_ROLE if world.game.penalised else kelpie.KEEPER
        self.explain(command.trace)
        return command

    def decide(self, world) -> kelpie.Command:
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.reset(world, 'play is halted', self.guard, GuardGoal(GuardEllipse))
            return self.idle(world)
        self.halted.end()
        if self.get_up.needed(world):
            self.reset(world, 'has fallen', self.guard, GuardGoal(GuardEllipse))
            return kelpie.Command(motion=self.get_up.step(world))
        return super().step(world)

    def idle(self, world) -> kelpie.Command:
        return self.halted.step(world)

    def explain(self, trace) -> None:
        super().explain(trace)
        self.halted.explain(trace)
        self.eyes.explain(trace)

    # States

    def guard(self, world):
        skill = PawKick() if self.paw else AttackBall()
        if attack_due(world) and attack_failed(world) is None and skill.can(world):
            return self.enter(world, self.attack, skill,
                              'the ball is {} cm away, {} cm beyond the box', world.ball.distance,
                              beyond_box(world.field, ball_of(world)))
        walk = self.skill.step(world, self.place(world))
        return kelpie.Command(walk=walk, head=self.eyes.step(world, True))

    def place(self, world):
        if not seen(world, GuardEllipse.UNSEEN):
            return central_place(world.field)
        return ellipse_place(world.field, ball_of(world))

    def attack(self, world):
        failed = attack_failed(world)
        if failed is not None or not self.skill.can(world):
            return self.enter(world, self.guard, GuardGoal(GuardEllipse),
                              *(failed or ('there is no place to kick from',)))
        best = None if self.paw else clearing_kick(world)
        if best is not None:
            return self.enter(world, self.clear, Kick(world, best.kick),
                              'to {} deg, {} deg off the own goal', best.direction, best.off_goal)
        # The head may glance now as well; the thesis found that it seldom comes to it (4.2.3).
        return kelpie.Command(walk=self.skill.step(world), head=self.eyes.step(world, True))

    def clear(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            return self.enter(world, self.guard, GuardGoal(GuardEllipse), 'the kick has ended')
        return kelpie.Command(motion=motion, head=self.eyes.step(world, False))
