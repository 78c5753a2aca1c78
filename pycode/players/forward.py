# SPDX-License-Identifier: Apache-2.0
# A player of the field (pForward, thesis 2006 figure 4.1 and section 4.4): gets up when it has
# fallen, walks to its place before a kick-off, waits while play is halted, and plays the role that
# it chooses; alone it is the attacker. Keeps the memory, the role with its choice, which team has
# the ball, and the way to its place. Tells the team in each frame what it is about to do. The trace
# of each Command says why, from here down to the skill.
import kelpie
from arbiter.rules import RuleMachine, holds
from decisions.roles import NAMES, RoleChoice
from lib import rulebook
from roles.attacker import Attacker
from roles.supporter import Supporter
from situation import time_to
from situation.memory import Memory
from situation.possession import Possession
from skills.head.watch import Scan
from skills.motion.get_up import GetUp
from skills.walk.take_place import TakePlace


def is_halted(world, playing):
    game = world.game
    if game.state == kelpie.PLAYING and not game.penalised:
        return None
    halted = game.penalised or game.state in (kelpie.INITIAL, kelpie.FINISHED)
    return ('play is halted',) if halted else None


def has_fallen(world, playing):
    """Who is set may not move."""
    falls = world.game.state != kelpie.SET and GetUp.needed(world)
    return ('it has fallen',) if falls else None


def gets_ready(world, playing):
    return ('the team gets ready',) if world.game.state != kelpie.PLAYING else None


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
        self.possession = Possession(self.memory)
        self.role = Attacker(self.memory)
        self.place = None

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        self.choose(world, world)
        command = self.state(world)
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
        if rulebook.follows_play(world):
            self.possession.update(world)
        role = self.choice.update(world, self.memory, self.role.committed)
        if role != role_of(self.role):
            self.role = (Attacker(self.memory) if role == kelpie.ATTACKER else
                         Supporter(self.memory, role, self.possession))
        self.with_mates = len(world.teammates) > 0
        command = self.role.step(world)
        self.tell(world, command.team)
        return command

    def explain(self, trace) -> None:
        if self.state == self.plays:
            why = self.choice.why if self.with_mates else (self.why,)
            branch = NAMES[self.choice.role] if self.with_mates else 'plays'
            trace.append((self.LAYER, self.NAME, branch, *why))
            self.possession.explain(trace)
            self.role.explain(trace)
        elif self.state == self.takes_place:
            waits = self.place.state == self.place.set
            trace.append((self.LAYER, self.NAME, 'waits', 'all are set') if waits else
                         (self.LAYER, self.NAME, self.playing, self.why))
            self.place.explain(trace)
        else:
            trace.append((self.LAYER, self.NAME, self.playing, self.why))

    def tell(self, world, note):
        """What the team hears of it."""
        note.role = self.choice.role
        note.time_to_ball = self.choice.seconds
        note.grabs = time_to.grabs_now(world, self.memory)
        note.pass_to = self.role.pass_to
        note.possession = self.possession.own
        wanted = self.role.wanted(world) if world.game.state == kelpie.PLAYING else None
        if wanted is not None:
            note.wants, note.wanted.x, note.wanted.y = True, wanted[0], wanted[1]


def role_of(role) -> int:
    return getattr(role, 'role', kelpie.ATTACKER)
