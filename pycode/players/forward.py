# SPDX-License-Identifier: Apache-2.0
# A player of the field (pForward, thesis 2006 figure 4.1 and section 4.4): gets up when it has
# fallen, walks to its place before a kick-off, waits while play is halted, and plays the role that
# it chooses; alone it is the attacker. Keeps the memory, the role with its choice, and the way to
# its place. Tells the team in each frame what it is about to do. The trace of each Command says
# why, from here down to the skill.
import kelpie
from arbiter.skill import Skill
from decisions.roles import NAMES, RoleChoice
from roles.attacker import Attacker
from roles.supporter import Supporter
from situation import time_to
from situation.memory import Memory
from skills.head.watch import Scan
from skills.motion.get_up import GetUp
from skills.walk.take_place import TakePlace


class Forward(Skill):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'forward'

    def __init__(self):
        self.memory = Memory()
        self.get_up = GetUp()
        self.start_over()

    def start_over(self):
        """Whatever interrupted it left nothing of its role."""
        self.choice = RoleChoice()
        self.role = Attacker(self.memory)
        self.place = None

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        if world.game.state in (kelpie.READY, kelpie.SET) and not world.game.penalised:
            command, told = self.takes_place(world)
        elif world.game.state != kelpie.PLAYING or world.game.penalised:
            self.start_over()
            command = kelpie.Command(head=Scan().step(world, world.time_s))
            told = [(kelpie.LAYER_PLAYER, 'forward', 'waits', 'play is halted')]
        elif self.get_up.needed(world):
            self.start_over()
            command, told = self.gets_up(world)
        else:
            command, told = self.plays(world)
        command.trace = told
        return command

    def gets_up(self, world):
        return (kelpie.Command(motion=self.get_up.step(world)),
                [(kelpie.LAYER_PLAYER, 'forward', 'gets_up', 'it has fallen')])

    def takes_place(self, world):
        """Before a kick-off: to its place in the ready state, there it stands when set."""
        if self.place is None:
            self.start_over()
            self.place = TakePlace(self.memory)
        if world.game.state == kelpie.READY and self.get_up.needed(world):
            return self.gets_up(world)
        command = self.place.step(world)
        told = [(kelpie.LAYER_PLAYER, 'forward', 'takes_place', 'the team gets ready')]
        if world.game.state == kelpie.SET:  # who attacks is agreed before the whistle
            self.choice.update(world, self.memory)
            self.tell(world, command.team)
            told = [(kelpie.LAYER_PLAYER, 'forward', 'waits', 'all are set')]
        self.place.explain(told)
        return command, told

    def plays(self, world):
        self.place = None
        role = self.choice.update(world, self.memory, self.role.committed)
        if role != role_of(self.role):
            self.role = (Attacker(self.memory) if role == kelpie.ATTACKER else
                         Supporter(self.memory, role))
        command = self.role.step(world)
        self.tell(world, command.team)
        alone = len(world.teammates) == 0
        told = [(kelpie.LAYER_PLAYER, 'forward', 'plays', 'play is on')] if alone else [
            (kelpie.LAYER_PLAYER, 'forward', NAMES[role], *self.choice.why)]
        self.role.explain(told)
        return command, told

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
