# SPDX-License-Identifier: Apache-2.0
"""Passes of a held ball, who waits for one, and places that value one."""
import math
import random

import kelpie
import pytest
from decisions import passing, positions_passing
from decisions.held_choice import HeldChoice
from lib import kick_table
from roles.supporter import Supporter
from situation.contested import Contested
from situation.keep_off import Lane
from situation.memory import Memory
from situations import world
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold
from test_roles import A, S, mate

BALL = (100.0, 208.0)


def holder(at=(100.0, 200.0), heading=90.0, opponents=()):
    made = world(*at, heading, (at[0], at[1] + 8.0))
    made.task.passing = True
    made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y))
                      for x, y in opponents]
    return made


def where(made, kick):
    """Where the ball of a held kick comes to rest."""
    _, direction, _, distance, _ = kick_table.held_outcome(kick)
    angle = math.radians(made.pose.heading_deg + direction)
    return BALL[0] + distance * math.cos(angle), BALL[1] + distance * math.sin(angle)


def test_a_mate_where_a_kick_sends_the_ball_can_be_passed_to():
    made = holder()
    made.teammates = [mate(3, S, at=where(made, kelpie.HARD_FORWARD))]
    utility, kick, player = passing.best(made, BALL)
    assert kick == kelpie.HARD_FORWARD and player == 3 and utility > 0.0


@pytest.mark.parametrize('other', [
    mate(3, S, at=(300.0, 60.0)), mate(3, kelpie.KEEPER, at=(100.0, 370.0)),
    mate(3, S, at=(100.0, 370.0), heard_s=2.0), mate(3, kelpie.NO_ROLE, at=(100.0, 370.0)),
    mate(3, S, at=(100.0, 230.0))])
def test_nobody_passes_to_who_is_out_of_the_way_a_goalie_silent_penalised_or_too_near(other):
    made = holder()
    made.teammates = [other]
    assert passing.best(made, BALL) is None


@pytest.mark.parametrize('place, gets_it', [
    ((134.0, 250.0), True), ((136.0, 250.0), False), ((100.0, 159.0), False),
    ((100.0, 161.0), True), ((158.0, 300.0), True), ((162.0, 300.0), False)])
def test_a_mate_stops_a_ball_within_35_cm_of_its_way_or_walks_60_to_where_it_rests(place, gets_it):
    way = Lane('', (100.0, 100.0), (100.0, 300.0), 25.0)
    assert passing.arrives(way, place) is gets_it


def test_an_opponent_on_the_way_stops_a_pass():
    made = holder(opponents=[(100.0, 300.0)])
    made.teammates = [mate(3, S, at=(100.0, 375.0))]
    assert passing.best(made, BALL) is None


def test_a_balls_utility_is_higher_nearer_to_the_goal_and_with_the_goal_open():
    made = holder()
    assert passing.utility_at(made, (180.0, 450.0)) > passing.utility_at(made, (180.0, 250.0))
    before = passing.utility_at(made, (180.0, 450.0))
    made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=180.0, y=500.0))]
    assert passing.utility_at(made, (180.0, 450.0)) < before


def choosing(made):
    memory = Memory()
    choice = HeldChoice(memory, Contested())
    skill = GrabDribble(memory, choice.choose, 'grab_turn_shoot')
    skill.hold = Hold(made, made.time_s)
    return choice, choice.choose(made, skill, False)


def facing_away():
    """It looks across the field, and a mate stands where its kick goes, before the goal."""
    made = holder((345.0, 500.0), 180.0)
    made.heading_sd_deg, made.seconds_since_landmark = 1.0, 0.0
    made.teammates = [mate(4, S, at=(190.0, 470.0))]
    return made


def test_who_holds_the_ball_passes_to_a_mate_that_is_better_placed_and_says_to_whom():
    choice, (kick, reason, *reported) = choosing(facing_away())
    assert choice.pass_to == 4 == reported[0] and reason.startswith('pass')
    assert isinstance(kick, int)


@pytest.mark.parametrize('change', [
    lambda made: setattr(made.task, 'passing', False),
    lambda made: setattr(made, 'teammates', []),
    lambda made: setattr(made.teammates[0].pose.position, 'x', 310.0)])
def test_without_the_switch_mates_or_a_better_place_nobody_passes(change):
    made = facing_away()
    change(made)
    assert choosing(made)[0].pass_to == 0


def test_who_is_to_get_the_ball_waits_and_does_not_get_out_of_the_way():
    made = world(180.0, 400.0, -90.0, (180.0, 260.0))
    made.game.player = 4
    holding = mate(2, A, 0.5, at=(180.0, 250.0), grabs=kelpie.HOLDS)
    made.teammates = [holding]
    memory = Memory()
    memory.update(made)
    skill = Supporter(memory, S)
    skill.step(made)
    assert skill.state == skill.get_out_of_way
    holding.note.pass_to = 4
    command = skill.step(made)
    assert skill.state == skill.receive
    assert command.walk.forward == command.walk.left == 0.0


# Places

def test_a_striker_leaves_a_place_that_no_ball_reaches_for_a_free_one():
    made = holder(opponents=[(200.0, 275.0)])
    place = (300.0, 350.0)
    assert not passing.clear(made, BALL, place)
    better = positions_passing.moved(made, S, place, BALL, None)
    assert passing.clear(made, BALL, better) and better != place


def test_with_nobody_in_the_way_the_place_is_near_that_of_the_tree_and_stays():
    made = holder()
    place = (250.0, 290.0)
    one = positions_passing.moved(made, S, place, BALL, None)
    assert positions_passing.apart(one, place) < 60.0
    assert positions_passing.moved(made, S, place, BALL, one) == one


@pytest.mark.parametrize('ball', [(60.0, 300.0), (180.0, 300.0), (330.0, 200.0)])
def test_a_defender_stands_on_the_line_from_ball_to_own_goal(ball):
    x, y = positions_passing.covering(holder().field, (180.0, 120.0), ball)
    assert y == 120.0 and (x - 180.0) / 120.0 == pytest.approx((ball[0] - 180.0) / ball[1])


@pytest.mark.parametrize('aside, ago_s, free', [
    (24.0, 1.9, False), (26.0, 1.9, True), (24.0, 2.1, True)])
def test_a_way_is_free_25_cm_beside_an_opponent_and_of_one_unseen_for_2_s(aside, ago_s, free):
    made = holder(opponents=[(180.0 + aside, 300.0)])
    made.opponents[0].seconds_since_seen = ago_s
    assert passing.clear(made, (180.0, 200.0), (180.0, 400.0)) is free


@pytest.mark.parametrize('opponents, shot', [((), 0.25), ([(180.0, 500.0)], 0.0)])
def test_a_pass_is_worth_three_quarters_of_nearness_and_shot(opponents, shot):
    """Halfway to where a shot no longer reaches the goal."""
    nearness = 0.6 * (1.0 - 115.0 / 650.0)
    assert passing.utility_at(holder(opponents=opponents), (180.0, 425.0)) == pytest.approx(
        0.75 * (nearness + shot))


@pytest.mark.parametrize('opponents, ball, worth', [
    ((), (180.0, 135.0), 160.0), ((), (180.0, 125.0), 157.0), ((), (180.0, 145.0), 157.0),
    ([(180.0, 215.0)], (180.0, 135.0), 70.0), ([(180.0, 400.0)], (180.0, 135.0), 130.0),
    ([(229.0, 300.0)], (180.0, 135.0), 120.0), ([(231.0, 300.0)], (180.0, 135.0), 160.0)])
def test_a_place_is_worth_a_way_for_a_free_pass_a_free_shot_and_for_being_unmarked(opponents, ball,
                                                                                  worth):
    place = (180.0, 300.0)
    made = holder(opponents=opponents)
    assert positions_passing.utility(made, place, place, ball) == pytest.approx(worth)


def test_a_place_for_a_pass_is_the_trees_or_one_of_six_about_it_to_either_side_alike():
    chance, steps = random.Random(5), set()
    for _ in range(300):
        around = [(chance.uniform(100, 260), chance.uniform(180, 400)) for _ in range(3)]
        place, ball = (chance.uniform(140, 220), 300.0), (chance.uniform(140, 220), 170.0)
        x, y = positions_passing.moved(holder(opponents=around), S, place, ball, None)
        mirrored = holder(opponents=[(360.0 - ox, oy) for ox, oy in around])
        other = positions_passing.moved(mirrored, S, (360.0 - place[0], 300.0),
                                        (360.0 - ball[0], 170.0), None)
        assert other == pytest.approx((360.0 - x, y))
        steps.add((round(x - place[0]), round(y - place[1])))
    assert steps == {(0, 0), (70, 0), (-70, 0), (0, 60), (0, -60), (50, 50), (-50, 50)}


@pytest.mark.parametrize('up_field, stays', [(15.0, True), (16.0, False)])
def test_a_place_for_a_pass_is_kept_against_one_that_is_up_to_20_cm_better(up_field, stays):
    """A cm farther from the tree's place and from where kicks go counts as 1.3."""
    place, ball, before = (180.0, 300.0), (180.0, 135.0), (180.0, 300.0 + up_field)
    assert (positions_passing.moved(holder(), S, place, ball, before) == before) is stays
