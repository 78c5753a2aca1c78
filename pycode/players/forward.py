# SPDX-License-Identifier: Apache-2.0
# A player of the field (pForward, thesis 2006 figure 4.1): gets up when it has fallen, waits while
# play is halted, and plays its role; alone it is the attacker. Keeps the memory, the role and what
# it did. The trace of each Command says why, from here down to the skill.
import kelpie
from lib.memory import Memory
from roles.attacker import Attacker
from skills.get_up import GetUp
from skills.watch import Scan


class Forward:
    def __init__(self):
        self.memory = Memory()
        self.role = Attacker(self.memory)
        self.get_up = GetUp()

    def command(self, world) -> kelpie.Command:
        self.memory.update(world)
        told = [(kelpie.LAYER_PLAYER, 'forward', 'plays', 'play is on')]
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.role = Attacker(self.memory)
            command = kelpie.Command(head=Scan().head(world, world.time_s))
            told = [(kelpie.LAYER_PLAYER, 'forward', 'waits', 'play is halted')]
        elif self.get_up.needed(world):
            self.role = Attacker(self.memory)
            command = kelpie.Command(motion=self.get_up.motion(world))
            told = [(kelpie.LAYER_PLAYER, 'forward', 'gets_up', 'it has fallen')]
        else:
            command = self.role.command(world)
            self.role.explain(told)
        command.trace = told
        return command
