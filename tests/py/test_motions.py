# SPDX-License-Identifier: Apache-2.0
"""Skills that answer with a motion: asked for until it runs, over when it has run, given up in the
end; and which motion gets a fallen robot up."""
import kelpie
import pytest
from players.forward import Forward
from situations import world
from skills.motion.get_up import GetUp
from skills.motion.kick import Kick
from skills.motion.release import Release

# The skill, its motion, s for it to begin and s that it may take.
MOTIONS = [(Kick, kelpie.KICK_FORWARD, 1.5, 5.0), (Release, kelpie.RELEASE, 0.6, 2.0)]


@pytest.mark.parametrize('kind, motion, start_s, longest_s', MOTIONS)
def test_a_motion_is_asked_for_until_it_runs_and_is_over_when_it_has_run(kind, motion, start_s,
                                                                        longest_s):
    made = world()
    made.time_s = 7.0
    skill = kind(made)
    nothing = kelpie.NO_MOTION
    for running, asked, done in ((nothing, motion, False), (motion, nothing, False),
                                 (nothing, nothing, True)):
        made.time_s, made.motion.running = made.time_s + 0.03, running
        assert (skill.step(made), skill.done) == (asked, done)


@pytest.mark.parametrize('kind, motion, start_s, longest_s', MOTIONS)
def test_a_motion_that_does_not_begin_is_given_up(kind, motion, start_s, longest_s):
    for seconds, done in ((start_s - 0.01, False), (start_s + 0.01, True)):
        made = world()
        made.time_s = 7.0
        skill = kind(made)
        made.time_s += seconds
        assert skill.step(made) == motion and skill.done is done


@pytest.mark.parametrize('kind, motion, start_s, longest_s', MOTIONS)
def test_a_motion_that_does_not_end_is_given_up(kind, motion, start_s, longest_s):
    for seconds, done in ((longest_s - 0.01, False), (longest_s + 0.01, True)):
        made = world()
        made.time_s, made.motion.running = 7.0, motion
        skill = kind(made)
        made.time_s += seconds
        assert skill.step(made) == kelpie.NO_MOTION and skill.done is done


def test_another_motion_that_runs_is_not_the_kick():
    made = world()
    skill = Kick(made, kelpie.WEDGE)
    made.motion.running = kelpie.HARD_FORWARD
    assert skill.step(made) == kelpie.WEDGE and not skill.done


@pytest.mark.parametrize('fallen, motion', [
    (kelpie.ON_FRONT, kelpie.GET_UP_FRONT), (kelpie.ON_BACK, kelpie.GET_UP_BACK),
    (kelpie.ON_LEFT, kelpie.GET_UP_LEFT), (kelpie.ON_RIGHT, kelpie.GET_UP_RIGHT)])
def test_who_lies_on_a_side_gets_up_from_it_and_asks_once(fallen, motion):
    made, skill = world(), GetUp()
    made.motion.feeling.fallen = fallen
    assert GetUp.needed(made)
    assert [skill.step(made) for _ in range(3)] == [motion, kelpie.NO_MOTION, motion]
    made.motion.running = motion
    assert [skill.step(made) for _ in range(2)] == [kelpie.NO_MOTION] * 2
    made.motion.feeling.fallen = kelpie.NOT_FALLEN
    assert GetUp.needed(made)
    made.motion.running = kelpie.NO_MOTION
    assert not GetUp.needed(made) and skill.step(made) == kelpie.NO_MOTION


@pytest.mark.parametrize('running', [kelpie.NO_MOTION, kelpie.GRAB, kelpie.HARD_FORWARD])
def test_who_stands_need_not_get_up(running):
    made = world()
    made.motion.running = running
    assert not GetUp.needed(made)


@pytest.mark.parametrize('state, penalised, fallen, does', [
    (kelpie.PLAYING, False, False, 'plays'), (kelpie.PLAYING, False, True, 'gets_up'),
    (kelpie.PLAYING, True, False, 'waits'), (kelpie.PLAYING, True, True, 'waits'),
    (kelpie.READY, False, False, 'takes_place'), (kelpie.READY, False, True, 'gets_up'),
    (kelpie.READY, True, False, 'waits'), (kelpie.SET, False, False, 'takes_place'),
    (kelpie.SET, False, True, 'takes_place'), (kelpie.INITIAL, False, False, 'waits'),
    (kelpie.INITIAL, False, True, 'waits'), (kelpie.FINISHED, False, False, 'waits')])
def test_a_forward_waits_gets_up_takes_its_place_or_plays_as_the_game_stands(state, penalised,
                                                                            fallen, does):
    made, forward = world(), Forward()
    made.game.state, made.game.penalised = state, penalised
    made.motion.feeling.fallen = kelpie.ON_LEFT if fallen else kelpie.NOT_FALLEN
    command = forward.step(made)
    assert forward.playing == does
    assert command.motion == (kelpie.GET_UP_LEFT if does == 'gets_up' else kelpie.NO_MOTION)


def test_a_forward_tells_its_mates_the_place_that_it_goes_to():
    made, forward = world(180.0, 200.0, 90.0, (140.0, 300.0)), Forward()
    made.game.state = kelpie.PLAYING
    note = forward.step(made).team
    assert note.wants and (note.wanted.x, note.wanted.y) == (140.0, 300.0)
