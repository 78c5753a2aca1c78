# SPDX-License-Identifier: Apache-2.0
# The base of state machines that take one step per camera frame, and of what they tell of
# themselves. It keeps the state (a bound method), that state's skill, when it was entered and why,
# with the numbers that decided; all of it comes from enter() and reset(), nothing from the world.
# It fails where states enter one another in a circle: after MAX_ENTRIES in one frame idle() answers
# for them.
from arbiter.skill import Skill

MAX_ENTRIES = 4  # three states in one frame are the longest sane chain


class Machine(Skill):
    """A state is a method state(world) that returns the frame's answer, a Command for a player.

    A state may enter another one. If it answers all the same, the other begins with the next
    frame; if it returns None, the other is asked in this frame. reset() may come before any step:
    no state may leave work behind that only a later frame of it would end.
    """

    def __init__(self, state, skill=None):
        self.state = state
        self.skill = skill
        self.entered_s = None  # world.time_s when the state was entered; None before the first step
        self.why = 'the start'
        self.numbers = ()

    def enter(self, world, state, skill=None, why='', *numbers) -> None:
        """`why`: at most 80 characters, each {} of it for the next of at most three numbers."""
        self.state, self.skill, self.entered_s = state, skill, world.time_s
        self.why, self.numbers = why, numbers

    def reset(self, world, why: str, state, skill=None) -> None:
        """Enters a state, whatever the machine was doing, and keeps the reason in `why`."""
        self.enter(world, state, skill, why)

    def since(self, world) -> float:
        """Seconds since the state was entered."""
        return world.time_s - self.entered_s

    def timed_out(self, world, limit_s) -> bool:
        return self.since(world) > limit_s

    def step(self, world):
        """The answer of the state, or of the one that it entered without an answer."""
        if self.entered_s is None:
            self.entered_s = world.time_s
        for _ in range(MAX_ENTRIES):
            answer = self.state(world)
            if answer is not None:
                return answer
        return self.idle(world)

    def idle(self, world):
        """The answer when the states of a frame come to none."""
        raise NotImplementedError('states enter one another in a circle')

    def explain(self, trace) -> None:
        """Appends what it does and why to a list for Command.trace, and lets its skill go on."""
        trace.append((self.LAYER, self.NAME, self.state.__name__, self.why, *self.numbers))
        if isinstance(self.skill, Skill):
            self.skill.explain(trace)
