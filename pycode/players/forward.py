# SPDX-License-Identifier: Apache-2.0
# A player of the field (pForward, thesis 2006 figure 4.1 and section 4.4): gets up when it has
# fallen, walks to its place before a kick-off, waits while play is halted, and plays the role that
# it chooses; alone it is the attacker. Keeps the memory, the role with its choice, and the way to
# its place. Tells the team in each frame what it is about to do. The trace of each Command says
# why, from here down to the skill.
import kelpie
from arbiter.rules import RuleMachine, holds
from decisions.roles import NAMES, RoleChoice
from roles.attacker import Attacker
from roles.supporter import Supporter
from situation import time_to
from situation.memory import Memory
from skills.head.watch import Scan
from skills.motion.get_up import GetUp
from skills.walk.take_place import TakePlace


class ForwardSituation:
    """What a player of the field decides by before its role does."""

    def __init__(self, world, fallen):
        game = world.game
        self.world, self.fallen = world, fallen
        self.before_kick_off = game.state in (kelpie.READY, kelpie.SET) and not game.penalised
        self.halted = not self.before_kick_off and (game.state != kelpie.PLAYING or game.penalised)


def is_halted(now, playing):
    return ('play is halted',) if now.halted else None


def has_fallen(now, playing):
    """Who is set may not move."""
    return ('it has fallen',) if now.fallen and now.world.game.state != kelpie.SET else None


def gets_ready(now, playing):
    return ('the team gets ready',) if now.before_kick_off else None


class Forward(RuleMachine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'forward'
    RULES = (
        (is_halted, 'waits'),
        (has_fallen, 'gets_up'),
        (gets_ready, 'takes_place'),
        (holds('play is on'), 'plays'))

    def __init__(self):
        super().__init__(self.waits)
        self.why = 'play is halted'
        self.memory = Memory()
        self.get_up = GetUp()
        self.with_mates = False
        self.start_over()

    def start_over(self):
        """Whatever interrupted it left nothing of its role."""
        self.choice = RoleChoice()
        self.role = Attacker(self.memory)
        self.place = None

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        self.choose(world, ForwardSituation(world, self.get_up.needed(world)))
        command = super().step(world)
        self.explain(command.trace)
        return command

    # States

    def waits(self, world):
        self.start_over()
        return kelpie.Command(head=Scan().step(world, world.time_s))

    def gets_up(self, world):
        if world.game.state == kelpie.PLAYING:
            self.start_over()
        return kelpie.Command(motion=self.get_up.step(world))

    def takes_place(self, world):
        """Before a kick-off: to its place in the ready state, there it stands when set."""
        if self.place is None:
            self.start_over()
            self.place = TakePlace(self.memory)
        command = self.place.step(world)
        if world.game.state == kelpie.SET:  # who attacks is agreed before the whistle
            self.choice.update(world, self.memory)
            self.tell(world, command.team)
        return command

    def plays(self, world):
        self.place = None
        role = self.choice.update(world, self.memory, self.role.committed)
        if role != role_of(self.role):
            self.role = (Attacker(self.memory) if role == kelpie.ATTACKER else
                         Supporter(self.memory, role))
        self.with_mates = len(world.teammates) > 0
        command = self.role.step(world)
        self.tell(world, command.team)
        return command

    def explain(self, trace) -> None:
        branch, why = self.playing, (self.why,)
        if self.state == self.takes_place and self.place.state == self.place.set:
            branch, why = 'waits', ('all are set',)
        elif self.state == self.plays and self.with_mates:
            branch, why = NAMES[self.choice.role], self.choice.why
        trace.append((self.LAYER, self.NAME, branch, *why))
        below = {self.takes_place: self.place, self.plays: self.role}.get(self.state)
        if below is not None:
            below.explain(trace)

    def tell(self, world, note):
        """What the team hears of it."""
        note.role = self.choice.role
        note.time_to_ball = self.choice.seconds
        note.grabs = time_to.grabs_now(world, self.memory)
        note.pass_to = self.role.pass_to
        wanted = self.role.wanted(world) if world.game.state == kelpie.PLAYING else None
        if wanted is not None:
            note.wants, note.wanted.x, note.wanted.y = True, wanted[0], wanted[1]


def role_of(role) -> int:
    return getattr(role, 'role', kelpie.ATTACKER)
