# SPDX-License-Identifier: Apache-2.0
# A player that chooses what it does by ordered rules: of each frame the first that holds says the
# state and why. A rule is a test and the state's name; the test is asked with the situation of the
# frame and the name of the state that is played, for its hysteresis, and changes nothing. A state
# that is committed comes to its own end before the rules are asked again. Keeps what a Machine
# keeps. A player without a rule that always holds stays in its state when none does.
from arbiter.machine import Machine

Reason = tuple   # why, at most 80 characters with {} for each of at most three numbers that follow


def holds(why, *numbers):
    """A test that always holds: the last rule of a player."""
    return lambda now, playing: (why, *numbers)


class RuleMachine(Machine):
    RULES = ()       # (test(now, playing) -> Reason or None, state's name) in the order of asking
    COMMITTED = ()   # names of the states that come to their own end

    @property
    def playing(self) -> str:
        """The name of the state that is played."""
        return self.state.__name__

    @property
    def committed(self) -> bool:
        return self.playing in self.COMMITTED

    def choose(self, world, now) -> None:
        """Enters the state of the first rule that holds, unless it is played already. Not to be
        asked of a state that is committed."""
        playing = self.state.__name__
        for test, name in self.RULES:
            if reason := test(now, playing):
                if name != playing:
                    self.change(world, now, name, reason)
                return

    def change(self, world, now, name, reason) -> None:
        """From one state to another: the skill of the one ends, that of the other is made."""
        if self.skill is not None:
            self.skill.end()
        self.enter(world, getattr(self, name), self.skill_of(name, now), *reason)

    def skill_of(self, name, now):
        """The skill that a state plays, begun anew; None for one that has none."""
        return None
