# SPDX-License-Identifier: Apache-2.0
# The goalie of 2004 (thesis 2004 section 4.2): stands where the line from the ball to the goal's
# middle crosses an ellipse around the mouth, lazily; attacks a ball in its box or at its nose, by a
# swipe of a foreleg as the final code did or by the paw kick of the first version; keeps its legs
# off the wall beside the goal. Keeps the state and its head. It does not block, so hard shots into
# a gap go in, and it looks at nobody but the ball. Its thesis lets it out of the box; the rule of
# 2006 holds for it, too (checklist K07).
import kelpie
from arbiter.rules import RuleMachine
from lib import rulebook
from lib.goalie_places import beyond_box, central_place, ellipse_place
from lib.paths import point_of
from lib.steer import filtered
from players.halted import Halted
from safety.rear_wall import off_wall
from situation import kick_stand
from situation.clearance import clearing_kick
from situation.goalie import seen
from situation.memory import Memory
from skills.ball.attack_ball import AttackBall
from skills.ball.paw_kick import Paw, PawKick
from skills.head.ellipse_head import EllipseHead
from skills.motion.get_up import GetUp
from skills.motion.kick import Kick
from skills.walk.guard_goal import OF_2004, GuardGoal


LEAVE = 15.0         # cm beyond the box (thesis 2004 section 4.2.2)
UNSEEN_NEAR = 1.0    # s; the chin hides a near ball
UNSEEN = 4.0         # s that an unseen ball is believed; then to the middle


def attack_due(world) -> bool:
    """Whether the ball of gps is in the box or the seen one at the nose."""
    if not world.ball.present:
        return False
    in_box = beyond_box(world.field, point_of(world.ball)) == 0.0
    near = world.percepts.ball.present and world.percepts.ball.distance < Paw.VISUAL
    return in_box or near


def attack_failed(world) -> tuple | None:
    """Why an attack is broken off, with a number; None if it goes on."""
    away = beyond_box(world.field, point_of(world.ball))
    percept = world.percepts.ball
    if away > LEAVE:
        return 'the ball is {} cm beyond the box', away
    if percept.present and abs(percept.heading_deg) > Paw.MAX_OFF:
        return 'the ball is seen {} deg aside', percept.heading_deg
    if not rulebook.of(world).PAW_KICK and not seen(world, UNSEEN_NEAR):
        return 'the ball is unseen for {} s', world.ball.seconds_since_seen
    return None


def attacks(now, playing):
    goes_on = playing == 'attack'
    if attack_failed(now.world) is not None or not (goes_on or attack_due(now.world)):
        return None
    if not now.can_attack(now.world, goes_on):
        return None
    return ('the ball is {} cm away, {} cm beyond the box', now.world.ball.distance,
            beyond_box(now.world.field, point_of(now.world.ball)))


def guards(now, playing):
    return attack_failed(now.world) or ('there is no place to kick from',)


class EllipseGoalie(RuleMachine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'ellipse_goalie'
    RULES = (
        (attacks, 'attack'),
        (guards, 'guard'))
    COMMITTED = ('clear',)
    WALKED = (off_wall,)

    def __init__(self, paw=False):
        super().__init__(self.guard, GuardGoal(OF_2004))
        self.world = None   # the frame
        self.paw = paw      # attack by the paw kick of the first version
        self.stands = kick_stand.Choice()
        self.memory = Memory()
        self.eyes = EllipseHead(self.memory)
        self.get_up = GetUp()
        self.halted = Halted(self.memory, self.get_up)

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        self.world = world
        command = self.decide(world)
        command.walk = filtered(self, command.walk, self.WALKED)
        command.team.role = kelpie.NO_ROLE if world.game.penalised else kelpie.KEEPER
        self.explain(command.trace)
        return command

    def decide(self, world) -> kelpie.Command:
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.reset(world, 'play is halted', self.guard, GuardGoal(OF_2004))
            return self.idle(world)
        self.halted.end()
        if self.get_up.needed(world):
            self.reset(world, 'has fallen', self.guard, GuardGoal(OF_2004))
            return kelpie.Command(motion=self.get_up.step(world))
        if not self.committed:
            self.choose(world, self)
        return super().step(world)

    def idle(self, world) -> kelpie.Command:
        return self.halted.step(world)

    def explain(self, trace) -> None:
        super().explain(trace)
        self.halted.explain(trace)
        self.eyes.explain(trace)

    def skill_of(self, name, now):
        if name == 'attack':
            return PawKick() if self.by_paw(now.world) else AttackBall()
        return GuardGoal(OF_2004)

    # States

    def guard(self, world):
        walk = self.skill.step(world, self.place(world))
        return kelpie.Command(walk=walk, head=self.eyes.step(world, True))

    def can_attack(self, world, goes_on) -> bool:
        """Whether there is a place to kick the ball from; the paw kick only runs."""
        if self.by_paw(world):
            return True
        self.stands = kick_stand.choose(world, self.stands if goes_on else None)
        return self.stands.stand is not None

    def by_paw(self, world) -> bool:
        return self.paw or rulebook.of(world).PAW_KICK

    def place(self, world):
        if not seen(world, UNSEEN):
            return central_place(world.field)
        return ellipse_place(world.field, point_of(world.ball))

    def attack(self, world):
        best = None if self.by_paw(world) else clearing_kick(world)
        if best is not None:
            return self.enter(world, self.clear, Kick(world, best.kick),
                              'to {} deg, {} deg off the own goal', best.direction, best.off_goal)
        # The head may glance now as well; the thesis found that it seldom comes to it (4.2.3).
        return kelpie.Command(walk=self.skill.step(world, self.stands.stand),
                              head=self.eyes.step(world, True))

    def clear(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            self.enter(world, self.guard, GuardGoal(OF_2004), 'the kick has ended')
            return self.choose(world, self)   # a ball that lies there still is attacked at once
        return kelpie.Command(motion=motion, head=self.eyes.step(world, False))
