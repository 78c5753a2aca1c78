# SPDX-License-Identifier: Apache-2.0
"""The player of the field in an ideal world: it scores with a grab and without, keeps the rules of
holding, waits, gets up, and comes back to the search from wherever it was."""
import functools

import kelpie
import pytest
from ideal_world import FRAME_S, IdealWorld, play
from players.forward import Forward

STARTS = 20
WITHOUT = dict(grab=False, kicks=kelpie.KICKS_BY_RULES)
BY_RULES = dict(kicks=kelpie.KICKS_BY_RULES)
BY_MAP = dict(kicks=kelpie.KICKS_BY_MAP)


@functools.cache
def played(noise, **task):
    return [play(Forward().step, seed, 60.0, noise, task=kelpie.Task(**task))
            for seed in range(STARTS)]


def goals(noise, task):
    return sum(ideal.scored for ideal in played(noise, **task))


def standing(command):
    walk = command.walk
    return walk.forward == walk.left == walk.turn_deg == 0.0 and command.motion == kelpie.NO_MOTION


@pytest.mark.parametrize('task', [WITHOUT, BY_RULES, BY_MAP])
def test_scores_from_19_of_20_starts_in_a_minute(task):
    assert goals(0.0, task) >= 19


@pytest.mark.parametrize('task', [WITHOUT, BY_RULES, BY_MAP])
def test_scores_with_noise_and_a_wrong_pose(task):
    assert goals(1.0, task) >= 17


@pytest.mark.parametrize('task', [BY_RULES, BY_MAP])
@pytest.mark.parametrize('noise', [0.0, 1.0])
def test_no_ball_is_held_for_3_s_or_carried_50_cm(task, noise):
    ideals = played(noise, **task)
    assert sum(ideal.grabs for ideal in ideals) >= STARTS
    longest = max(ideal.longest for ideal in ideals)
    assert 1.0 < longest < kelpie.Rules().holding_time
    assert max(ideal.farthest for ideal in ideals) < kelpie.Rules().holding_distance


def test_who_may_not_grab_never_asks_for_a_grab():
    assert all(ideal.grabs == 0 and ideal.kicks > 0 for ideal in played(0.0, **WITHOUT))


def test_with_a_grab_goals_come_sooner():
    seconds = {task: sum(ideal.world.time_s for ideal in played(0.0, **settings))
               for task, settings in (('with', BY_RULES), ('without', WITHOUT))}
    assert seconds['with'] < seconds['without']


# Whatever happens, it goes on

def game(seed, task=BY_MAP):
    ideal = IdealWorld(seed)
    ideal.world.task = kelpie.Task(**task)
    ideal.see()
    return ideal, Forward()


def doing(player):
    """The states of the role and of its skill, and whether the ball is in the hold."""
    skill = getattr(player.role.skill, 'state', None)
    return player.role.state.__name__, skill.__name__ if skill else ''


def run_until(ideal, player, end_s):
    command = kelpie.Command()
    while ideal.world.time_s < end_s:
        command = player.step(ideal.world)
        ideal.step(command)
    return command


@pytest.mark.parametrize('task', [WITHOUT, BY_MAP])
def test_a_ball_never_seen_is_searched_for_without_end(task):
    ideal, player = game(3, task)
    ideal.hidden = True
    turned = walked = late = 0.0
    while ideal.world.time_s < 60.0:
        command = player.step(ideal.world)
        ideal.step(command)
        assert player.role.state == player.role.find
        turned += abs(command.walk.turn_deg) * FRAME_S
        walked += abs(command.walk.forward) * FRAME_S
        late += (ideal.world.time_s > 50.0) * abs(command.walk.forward) * FRAME_S
    assert turned > 720.0 and walked > 100.0 and late > 20.0


@pytest.mark.parametrize('task, met', [
    (WITHOUT, {('play', 'approach'), ('play', 'line_up'), ('play', 'strike')}),
    (BY_MAP, {('play', 'grab')})])
def test_a_ball_that_vanishes_while_it_is_played_is_searched_for(task, met):
    left = set()
    for vanish_s in range(2, 22):
        ideal, player = game(vanish_s, task)
        run_until(ideal, player, vanish_s)
        ideal.hidden = True
        left.add(doing(player))
        run_until(ideal, player, vanish_s + 6.0)
        assert player.role.state == player.role.find
    assert met <= left


@pytest.mark.parametrize('state', [kelpie.INITIAL, kelpie.SET, kelpie.FINISHED])
def test_nobody_walks_before_the_game_is_on(state):
    ideal, player = game(4)
    ideal.world.game.state = state
    for _ in range(90):
        ideal.see()
        command = player.step(ideal.world)
        assert standing(command) and command.trace[0][2] == 'waits'


@pytest.mark.parametrize('task', [WITHOUT, BY_MAP])
def test_a_halt_in_any_state_stops_it_and_leads_back_to_the_search(task):
    halted_in = set()
    for tenths in range(20, 200, 18):
        ideal, player = game(tenths, task)
        run_until(ideal, player, 0.1 * tenths)
        halted_in.add(doing(player)[0])
        ideal.world.game.penalised = True
        assert standing(player.step(ideal.world))
        assert player.role.state == player.role.find and not player.role.committed
        ideal.world.game.penalised = False
        command = player.step(ideal.world)
        assert [step[1] for step in command.trace[:2]] == ['forward', 'attacker']
    assert {'find', 'play'} <= halted_in


@pytest.mark.parametrize('side, motion', [
    (kelpie.ON_FRONT, kelpie.GET_UP_FRONT), (kelpie.ON_BACK, kelpie.GET_UP_BACK),
    (kelpie.ON_LEFT, kelpie.GET_UP_LEFT), (kelpie.ON_RIGHT, kelpie.GET_UP_RIGHT)])
def test_whoever_fell_gets_up_first_and_then_plays_on(side, motion):
    ideal, player = game(6)
    run_until(ideal, player, 3.0)
    ideal.held = False
    ideal.world.motion.feeling.fallen = side
    asked = []
    while ideal.world.motion.feeling.fallen != kelpie.NOT_FALLEN and len(asked) < 90:
        command = player.step(ideal.world)
        asked.append(command.motion)
        ideal.step(command)
    assert set(asked) == {kelpie.NO_MOTION, motion} and len(asked) < 60
    run_until(ideal, player, 40.0)
    assert ideal.kicks > 0


def test_whoever_is_held_by_others_gives_up_its_skill_in_time_and_starts_over():
    ideal, player = game(5, WITHOUT)
    ideal.ball = ideal.at + 100 * ideal.facing
    reasons = set()
    while ideal.world.time_s < 30.0:
        command = player.step(ideal.world)
        reasons |= {step[3] for step in command.trace}
        command.walk = kelpie.WalkRequest()
        ideal.step(command)
    assert any(reason.endswith(' has ended') for reason in reasons)


def test_paws_that_push_at_something_make_it_back_off():
    ideal, player = game(8)
    run_until(ideal, player, 1.0)
    ideal.world.motion.feeling.paw_blocked = [True, True]
    ideal.world.ball.distance = 150.0
    command = player.step(ideal.world)
    assert command.walk.forward < 0.0 and doing(player)[0] == 'back_off'
    ideal.world.motion.feeling.paw_blocked = [False, False]
    run_until(ideal, player, ideal.world.time_s + 2.0)
    assert doing(player)[0] != 'back_off'


def test_every_frame_tells_from_the_player_down_to_a_skill():
    ideal, player = game(2)
    while ideal.world.time_s < 20.0 and not ideal.scored:
        command = player.step(ideal.world)
        layers = [step[0] for step in command.trace]
        assert layers == sorted(layers) and layers[0] == kelpie.LAYER_PLAYER
        assert layers[-1] == kelpie.LAYER_SKILL
        ideal.step(command)


def test_a_ball_that_only_the_body_feels_is_searched_for():
    """gps tells a felt ball as seen now; vision has not seen it for long."""
    ideal, player = game(9)
    ideal.hidden, ideal.held = True, True
    for _ in range(90):
        ideal.step(kelpie.Command())
        ideal.world.ball.seconds_since_seen = 0.0
        player.step(ideal.world)
        assert player.role.state == player.role.find


def test_the_goal_is_looked_for_once_and_the_ball_is_found_again_after_it():
    ideal, player = game(18, WITHOUT)
    sweeps, before = 0, ''
    while ideal.world.time_s < 30.0 and not ideal.kicks:
        ideal.step(player.step(ideal.world))
        now = doing(player)[1]
        sweeps, before = sweeps + (now == 'look_for_goal' != before), now
    assert ideal.kicks > 0 and sweeps <= 2
