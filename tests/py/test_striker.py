# SPDX-License-Identifier: Apache-2.0
import kelpie
from ideal_world import IdealWorld, play
from players.striker import Striker


def test_scores_from_19_of_20_starts_in_a_minute():
    goals = [play(Striker().command, seed, 60.0).scored for seed in range(20)]
    assert sum(goals) >= 19


def test_scores_with_noise_and_a_wrong_pose():
    goals = [play(Striker().command, seed, 60.0, noise=1.0).scored for seed in range(20)]
    assert sum(goals) >= 17


def test_ball_never_seen_is_searched_for_without_end():
    ideal = IdealWorld(3)
    ideal.hidden = True
    player = Striker()
    turned = walked = 0.0
    for _ in range(30 * 60):
        ideal.see()
        command = player.command(ideal.world)
        turned += abs(command.walk.turn_deg) / 30
        walked += abs(command.walk.forward) / 30
        ideal.move_head(command.head)
        ideal.walk(command.walk)
    assert turned > 720 and walked > 100


def test_ball_that_vanishes_in_any_state_is_searched_for():
    left = set()
    for vanish_s in range(2, 40):
        ideal = IdealWorld(vanish_s)
        player = Striker()
        ideal.see()
        while ideal.world.time_s < vanish_s + 10:
            if not ideal.hidden and ideal.world.time_s > vanish_s:
                ideal.hidden = True
                left.add(player.state.__name__)
            ideal.step(player.command(ideal.world))
        assert player.state == player.search
    assert {'approach', 'line_up', 'strike'} <= left


def test_nobody_walks_before_the_game_is_on():
    ideal = IdealWorld(4)
    ideal.world.game.state = kelpie.SET
    player = Striker()
    for _ in range(150):
        ideal.see()
        command = player.command(ideal.world)
        assert (command.walk.forward, command.walk.turn_deg, command.motion) == (0, 0, 0)


def test_whoever_stands_in_the_way_makes_it_step_back_and_start_over():
    ideal = IdealWorld(5)
    player = Striker()
    ideal.see()
    ideal.ball = ideal.at + 100 * ideal.facing
    states = []
    while ideal.world.time_s < 60.0 and 'step_back' not in states:
        command = player.command(ideal.world)
        states.append(player.state.__name__)
        command.walk = kelpie.WalkRequest()  # held
        ideal.step(command)
    assert 'approach' in states and states[-1] == 'step_back'
    assert player.why == 'approach timed out'


def test_a_halt_in_any_state_leads_back_to_search():
    halted_in = set()
    for halt_s in range(2, 40):
        ideal = IdealWorld(halt_s)
        player = Striker()
        ideal.see()
        while ideal.world.time_s < halt_s:
            ideal.step(player.command(ideal.world))
        halted_in.add(player.state.__name__)
        ideal.world.game.penalised = True
        command = player.command(ideal.world)
        assert (command.walk.forward, command.walk.turn_deg, command.motion) == (0, 0, 0)
        assert player.state == player.search and player.why == 'play is halted'
    assert {'approach', 'line_up', 'strike'} <= halted_in
