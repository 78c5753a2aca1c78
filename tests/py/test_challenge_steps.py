# SPDX-License-Identifier: Apache-2.0
"""The steps of the challenge of 2004 (thesis 2004 section 4.1): when each begins and ends, and what
it asks of the map of pinks and of the mouth."""
from types import SimpleNamespace

import kelpie
import pytest
from players.challenger import Challenger
from situations import world


def challenge(state='find_out', time_s=20.0, sure=True, **skill):
    """A challenger in that state whose skill says what is given and stands."""
    made, player = world(180.0, 200.0), Challenger()
    made.modes = [kelpie.PoseMode(weight=1.0)]
    made.position_sd, made.heading_sd_deg, made.time_s = (3.0 if sure else 90.0), 2.0, time_s
    made.game.state = kelpie.PLAYING
    made.task = kelpie.Task(player=kelpie.CHALLENGER,
                            points=[60.0, 60.0, 300.0, 480.0, 60.0, 480.0, 300.0, 60.0, 180.0,
                                    270.0])
    said = {'rows': 0, 'rounds': 0, 'turning': False, 'done': False, 'point': (0.0, 0.0), **skill}
    stub = SimpleNamespace(step=lambda one: kelpie.Command(), explain=lambda trace: None,
                           watch=SimpleNamespace(step=lambda one: kelpie.HeadRequest()), **said)
    player.enter(made, getattr(player, state), stub)
    player.points = [(60.0, 60.0), (300.0, 480.0)]
    player.mapped = state in ('reorient', 'visit', 'announce', 'finish')
    return made, player


def after(made, player, seconds=0.1):
    made.time_s += seconds
    command = player.step(made)
    return player.state.__name__, command


@pytest.mark.parametrize('rows, sure, state', [(0, True, 'find_out'), (1, True, 'go_to_stand'),
                                               (1, False, 'find_out')])
def test_the_place_is_found_out_by_a_row_at_least(rows, sure, state):
    assert after(*challenge('find_out', rows=rows, sure=sure))[0] == state


@pytest.mark.parametrize('seconds, done, state', [(11.9, False, 'go_to_stand'),
                                                  (12.1, False, 'map_pinks'),
                                                  (0.1, True, 'map_pinks')])
def test_the_walk_to_where_the_map_is_made_takes_12_s_at_most(seconds, done, state):
    made, player = challenge('go_to_stand', done=done)
    found, command = after(made, player, seconds)
    assert found == state and command.pinks == kelpie.PINKS_OFF
    assert player.beyond is (state == 'map_pinks')


@pytest.mark.parametrize('rounds, turning, state, maps', [
    (2, False, 'map_pinks', True), (2, True, 'map_pinks', False), (3, False, 'go_to_stand', False)])
def test_the_map_is_made_in_three_rounds_while_it_does_not_turn(rounds, turning, state, maps):
    found, command = after(*challenge('map_pinks', rounds=rounds, turning=turning))
    assert found == state and (command.pinks == kelpie.PINKS_MAP) is maps


@pytest.mark.parametrize('time_s, stage2', [(9.8, False), (10.2, True)])
@pytest.mark.parametrize('halted', ['state', 'penalised'])
def test_play_halted_after_10_s_ends_the_map(time_s, stage2, halted):
    made, player = challenge('map_pinks', time_s, turning=True)
    if halted == 'state':
        made.game.state = kelpie.SET
    else:
        made.game.penalised = True
    _, command = after(made, player, 0.0)
    assert command.pinks == kelpie.PINKS_LOCALISE and command.trace[0][2] == 'waits'
    made.game.state, made.game.penalised, made.position_sd = kelpie.PLAYING, False, 90.0
    after(made, player)
    assert player.stage2 is stage2 and (player.state == player.reorient) is stage2


def test_a_known_place_ends_the_look_round_and_the_nearest_way_begins():
    made, player = challenge('reorient')
    made.pose.position.x, made.pose.position.y = 290.0, 470.0
    state, command = after(made, player)
    assert state == 'visit' and command.pinks == kelpie.PINKS_LOCALISE
    assert player.points == [(300.0, 480.0), (60.0, 60.0)]
    assert player.skill.point == (300.0, 480.0) and player.skill.near == 3.0
    assert after(*challenge('reorient', sure=False))[0] == 'reorient'


@pytest.mark.parametrize('sd, done, state', [
    (39.0, False, 'visit'), (41.0, False, 'reorient'), (39.0, True, 'announce'),
    (41.0, True, 'reorient')])
def test_on_the_way_a_pose_40_cm_unsure_is_lost(sd, done, state):
    made, player = challenge('visit', done=done)
    made.position_sd = sd
    assert after(made, player)[0] == state


@pytest.mark.parametrize('seconds, state, left', [(0.79, 'announce', 2), (0.81, 'visit', 1)])
def test_a_point_is_announced_with_the_mouth_open_for_0_8_s(seconds, state, left):
    made, player = challenge('announce')
    found, command = after(made, player, seconds)
    assert (found, len(player.points)) == (state, left)
    assert command.mouth_open and command.pinks == kelpie.PINKS_LOCALISE


def test_after_the_last_point_it_stands():
    made, player = challenge('announce')
    player.points = [(60.0, 60.0)]
    assert after(made, player, 0.9)[0] == 'finish'
    state, command = after(made, player)
    assert state == 'finish' and not command.mouth_open
    assert command.pinks == kelpie.PINKS_LOCALISE and command.walk.forward == 0.0
