# SPDX-License-Identifier: Apache-2.0
# What a goalie of either kind does while play is halted: stands and looks round, or before a
# kick-off gets up and walks to its place. Keeps the way to that place.
import kelpie
from arbiter.skill import Skill
from skills.head.watch import Scan
from skills.walk.take_place import TakePlace


class Halted(Skill):
    def __init__(self, memory, get_up):
        self.memory, self.get_up = memory, get_up
        self.place = None

    def step(self, world) -> kelpie.Command:
        if world.game.penalised or world.game.state not in (kelpie.READY, kelpie.SET):
            self.place = None
            return kelpie.Command(head=Scan().step(world, world.time_s))
        if self.get_up.needed(world):
            return kelpie.Command(motion=self.get_up.step(world))
        if self.place is None:
            self.place = TakePlace(self.memory, goalie=True)
        return self.place.step(world)

    def end(self):
        """Play goes on."""
        self.place = None

    def explain(self, trace) -> None:
        if self.place is not None:
            self.place.explain(trace)
