# SPDX-License-Identifier: Apache-2.0
import kelpie
import pytest
from arbiter.machine import Machine


class Lamp(Machine):
    """Dark for a second, then lit without a frame in between; `blink` answers and then is dark."""

    def __init__(self):
        super().__init__(self.dark)

    def dark(self, world):
        return self.enter(world, self.lit, 'oil') if self.timed_out(world, 1.0) else 'dark'

    def lit(self, world):
        return self.skill

    def blink(self, world):
        self.enter(world, self.dark)
        return 'blink'


def world_at(time_s):
    return kelpie.WorldFrame(time_s=time_s)


def test_time_in_a_state_counts_from_the_first_step():
    lamp = Lamp()
    assert [lamp.step(world_at(100.0 + 0.4 * i)) for i in range(4)] == ['dark'] * 3 + ['oil']
    assert lamp.since(world_at(101.7)) == pytest.approx(0.5)


def test_a_state_entered_with_an_answer_begins_with_the_next_frame():
    lamp = Lamp()
    lamp.enter(world_at(5.0), lamp.blink)
    assert lamp.step(world_at(5.0)) == 'blink'
    assert lamp.state == lamp.dark and lamp.step(world_at(5.5)) == 'dark'
    assert not lamp.timed_out(world_at(6.0), 1.0) and lamp.timed_out(world_at(6.01), 1.0)


def test_a_reset_says_why_and_takes_the_skill_away():
    lamp = Lamp()
    assert lamp.why == 'the start'
    lamp.enter(world_at(1.0), lamp.lit, 'oil')
    lamp.reset(world_at(2.0), 'wind', lamp.dark)
    assert (lamp.why, lamp.skill, lamp.since(world_at(2.5))) == ('wind', None, 0.5)
    assert lamp.step(world_at(2.5)) == 'dark'


class Circle(Machine):
    def __init__(self):
        super().__init__(self.here)

    def here(self, world):
        return self.enter(world, self.there)

    def there(self, world):
        return self.enter(world, self.here)


def test_states_that_enter_one_another_in_a_circle_end_idle():
    circle = Circle()
    with pytest.raises(NotImplementedError):
        circle.step(world_at(0.0))
    circle.idle = lambda world: 'idle'
    assert circle.step(world_at(0.0)) == 'idle'
