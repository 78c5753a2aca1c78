# SPDX-License-Identifier: Apache-2.0
"""Who does not play the ball, where places are by the play: near it, on the own side of it, never
standing; and who of them takes the ball over."""
import math

import kelpie
import pytest
from decisions.positions_play import BOX, MOST, SWAY, SWAY_S, defence, place, support, swayed
from lib.goalie_places import beyond_box
from roles.supporter import Supporter
from situation import time_to
from situation.memory import Memory
from situations import world
from skills.walk.run_to import CLEAR, RunTo, past
from test_roles import A, S, mate

FIELD = kelpie.FIELDS['2006']
D = kelpie.DEFENDER
GOAL = 0.5 * FIELD.width, 0.0


def by_play(made):
    made.task.run, made.task.positions = True, kelpie.POSITIONS_BY_PLAY
    return made


def played(made, role=S, lost=0):
    memory = Memory()
    memory.update(made)
    memory.ball_lost += lost
    skill = Supporter(memory, role)
    return skill, skill.step(made)


@pytest.mark.parametrize('ball', [(60.0, 300.0), (200.0, 120.0), (300.0, 500.0)])
def test_the_defender_is_on_the_way_from_the_ball_to_the_own_goal_and_follows_it(ball):
    x, y = defence(FIELD, ball)
    cross = (x - ball[0]) * (GOAL[1] - ball[1]) - (y - ball[1]) * (GOAL[0] - ball[0])
    assert cross == pytest.approx(0.0, abs=1e-6)
    assert 0.0 < math.dist((x, y), ball) <= MOST + 1e-6
    assert math.dist((x, y), GOAL) < math.dist(ball, GOAL)


@pytest.mark.parametrize('x, side', [(100.0, 1.0), (260.0, -1.0)])
def test_the_supporter_is_behind_the_ball_on_the_inner_side(x, side):
    at = support(FIELD, (x, 300.0))
    assert side * (at[0] - x) > 0.0 and at[1] < 300.0


def test_a_place_sways_to_both_sides_and_back():
    made, there = world(), (180.0, 200.0)
    offs = []
    for frame in range(int(SWAY_S * 30)):
        made.time_s = frame / 30.0
        offs.append(swayed(made, there, (180.0, 300.0))[0] - there[0])
    assert max(offs) == pytest.approx(SWAY, abs=0.5) and min(offs) == pytest.approx(-SWAY, abs=0.5)


def test_mates_sway_at_different_times():
    made, places = world(), set()
    made.time_s = 0.3
    for player in (2, 3, 4):
        made.game.player = player
        places.add(round(swayed(made, (180.0, 200.0), (180.0, 300.0))[0], 3))
    assert len(places) == 3


def test_each_place_is_on_the_field():
    made = by_play(world())
    for x in range(0, 361, 20):
        for y in range(0, 541, 20):
            for role in (S, D):
                at = place(made, role, (float(x), float(y)))
                assert 0.0 < at[0] < FIELD.width and 0.0 < at[1] < FIELD.length
                assert beyond_box(FIELD, at) >= BOX - 1e-6


@pytest.mark.parametrize('at', [(300.0, 350.0), (110.0, 120.0), (300.0, 100.0)])
def test_by_the_play_it_runs_along_whatever_the_attacker_does(at):
    made = by_play(world(*at, 90.0, (100.0, 200.0)))
    made.teammates = [mate(2, A, 2.0, at=(100.0, 150.0), grabs=kelpie.HOLDS)]
    skill, command = played(made)
    assert skill.state == skill.run_along
    assert math.hypot(command.walk.forward, command.walk.left) > 5.0


def test_by_the_play_a_ball_that_nobody_knows_is_looked_for():
    made = by_play(world(180.0, 200.0, 90.0, (100.0, 300.0)))
    assert played(made, lost=45)[0].playing == 'find_ball'


def test_the_theses_places_stay_whatever_is_switched_on():
    made = by_play(world(300.0, 350.0, 90.0, (100.0, 200.0)))
    made.task.rules = kelpie.RULES_OF_THESIS
    made.teammates = [mate(2, A, 2.0, at=(100.0, 150.0))]
    assert played(made)[0].playing == 'go_home'


def test_far_from_its_place_it_runs_ahead_and_near_it_looks_at_the_ball():
    made, skill = world(180.0, 100.0, 90.0), RunTo()
    walk = skill.step(made, ((180.0, 300.0), (60.0, 300.0)))
    assert walk.kind == kelpie.WALK_FAST and walk.forward > 50.0 and abs(walk.turn_deg) < 1.0
    walk = skill.step(made, ((180.0, 120.0), (60.0, 100.0)))
    assert skill.near and walk.turn_deg > 90.0


@pytest.mark.parametrize('x, side', [(175.0, -1.0), (185.0, 1.0)])
def test_who_stands_ahead_is_passed_on_the_nearer_side(x, side):
    made = world(180.0, 100.0, 90.0)
    made.teammates = [mate(2, A, 2.0, at=(x, 130.0))]
    assert side * past(made, (180.0, 100.0), (180.0, 300.0)) > 20.0


@pytest.mark.parametrize('x, side', [(171.0, 1.0), (189.0, -1.0)])
def test_the_ball_is_passed_on_the_way_home_and_not_taken_along(x, side):
    # A striker in a match pushed a ball home that lay so far behind it.
    made, home = world(180.0, 340.0, -90.0), (180.0, 200.0)
    walk = RunTo().step(made, (home, (x, 317.0)))
    assert side * walk.turn_deg > 100.0
    assert RunTo().step(made, (home, None)).turn_deg == pytest.approx(0.0, abs=1e-6)


def test_who_is_far_or_behind_turns_no_way():
    made = world(180.0, 100.0, 90.0)
    made.teammates = [mate(2, A, 2.0, at=(180.0, 101.0 + CLEAR)), mate(3, S, 2.0, at=(180.0, 80.0))]
    assert past(made, (180.0, 100.0), (180.0, 300.0)) == 0.0


def test_who_is_behind_the_ball_has_it_sooner_than_who_is_before_it():
    behind = by_play(world(180.0, 200.0, 90.0, (180.0, 260.0)))
    before = by_play(world(180.0, 320.0, -90.0, (180.0, 260.0)))
    seconds = [time_to.to_ball(made, 0, False, False) for made in (behind, before)]
    assert seconds[1] - seconds[0] == pytest.approx(time_to.ROUND_S)
    for made in (behind, before):
        made.task.run = False
    assert time_to.to_ball(behind, 0, False, False) == pytest.approx(
        time_to.to_ball(before, 0, False, False))
