# SPDX-License-Identifier: Apache-2.0
"""The home of who does not play the ball, from frame to frame: what the examples are asked, how
often, where one looks there, and where a pass may be had."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from decisions import kick_map_choice, passing, positions, positions_passing
from decisions import positions_regression as regressed
from decisions.held_choice import HeldChoice
from decisions.home import Home
from lib import kick_table
from situation.aim import Aim
from situation.contested import Contested
from situation.keep_off import Lane
from situation.memory import Memory
from situations import world
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold
from test_roles import A, S, mate

D = kelpie.DEFENDER


def opponent(x, y, ago_s=0.0):
    return kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y), seconds_since_seen=ago_s)


def asked(mates=(), opponents=(), role=S, ball=(180.0, 200.0)):
    """What a home by examples asks them: ball, angle, whether the team attacks, and for whom."""
    made, home, questions = world(), Home(), []
    made.task.positions = kelpie.POSITIONS_BY_REGRESSION
    made.teammates, made.opponents = list(mates), list(opponents)
    home.regressed = SimpleNamespace(
        place=lambda field, *question: questions.append(question) or (50.0, 200.0, 135.0))
    home.update(made, role, ball, ())
    return questions[0]


# By examples

@pytest.mark.parametrize('at, angle', [((100.0, 200.0), -90.0), ((260.0, 200.0), 90.0),
                                       ((180.0, 100.0), 0.0)])
def test_the_examples_are_asked_by_the_attackers_direction_to_the_ball(at, angle):
    ball, found, _, which = asked([mate(2, A, at=at)])
    assert (ball, which) == ((180.0, 200.0), 1) and found == pytest.approx(angle)


def test_without_an_attacker_its_place_is_taken_to_be_at_the_ball():
    assert asked([mate(2, S, at=(100.0, 100.0))])[1:3] == (0.0, False)
    assert asked(ball=(180.0, 300.0))[1:3] == (0.0, True)


@pytest.mark.parametrize('role, which', [(D, 0), (S, 1), (kelpie.SUPPORTER, 1)])
def test_the_defender_is_the_first_of_an_example_the_others_are_the_last(role, which):
    assert asked(role=role)[3] == which


@pytest.mark.parametrize('grabs, attacks', [(kelpie.HOLDS, True), (kelpie.GRABS_SOON, False),
                                            (kelpie.GRABS_NOT, False)])
def test_a_team_whose_mate_holds_the_ball_attacks_with_an_opponent_nearer_to_it(grabs, attacks):
    attacker = mate(2, A, at=(180.0, 150.0), grabs=grabs)
    assert asked([attacker], [opponent(190.0, 200.0)])[2] is attacks


@pytest.mark.parametrize('ago_s, attacks', [(1.9, False), (2.1, True)])
def test_opponents_unseen_for_2_s_are_not_nearer_to_the_ball(ago_s, attacks):
    """The only one known; without any, a ball in their half says that the team attacks."""
    attacker = mate(2, A, at=(180.0, 250.0))
    assert asked([attacker], [opponent(190.0, 300.0, ago_s)], ball=(180.0, 300.0))[2] is attacks


@pytest.mark.parametrize('attacker, opponents, attacks', [
    ((100.0, 260.0), [(130.0, 300.0)], False), ((100.0, 280.0), [(130.0, 300.0)], True),
    ((100.0, 260.0), [(100.0, 330.0)], False), ((100.0, 280.0), [(100.0, 330.0)], True),
    ((140.0, 300.0), [(100.0, 330.0)], False), ((80.0, 300.0), [(100.0, 330.0)], True),
    ((100.0, 260.0), [(300.0, 300.0), (130.0, 300.0)], False)])
def test_a_team_attacks_whose_attacker_is_nearer_than_the_nearest_opponent(attacker, opponents,
                                                                          attacks):
    others = [opponent(*place) for place in opponents]
    field = kelpie.FIELDS['2006']
    assert regressed.attacks((100.0, 300.0), attacker, False, others, field) is attacks


def test_the_examples_are_asked_in_every_tenth_frame():
    made, home = world(), Home()
    made.task.positions = kelpie.POSITIONS_BY_REGRESSION
    first = home.update(made, S, (100.0, 200.0), ())
    places = [home.update(made, S, (260.0, 400.0), ()) for _ in range(10)]
    assert places[:9] == [first] * 9 and places[9] != first


@pytest.mark.parametrize('heading, turn', [(90.0, 45.0), (135.0, 0.0), (180.0, -45.0),
                                           (-90.0, -135.0)])
def test_who_stands_by_examples_looks_along_their_heading(heading, turn):
    made, home = world(100.0, 300.0, heading), Home()
    home.raw = 100.0, 300.0, 135.0
    assert home.turn_deg(made, (300.0, 300.0)) == pytest.approx(turn)


@pytest.mark.parametrize('raw', [None, (100.0, 300.0, None)])
def test_who_stands_by_the_trees_looks_at_the_ball(raw):
    made, home = world(100.0, 300.0, 90.0), Home()
    home.raw = raw
    assert home.turn_deg(made, (200.0, 300.0)) == pytest.approx(-90.0)
    assert home.turn_deg(made, None) == 0.0


def test_examples_are_scaled_by_half_the_field_90_deg_and_1():
    """Checklist G25; divided by the bandwidth."""
    model = regressed.RegressedPositions()
    assert model.regression.scaled((180.0, 270.0, 90.0, 1.0)) == pytest.approx((1 / 0.42,) * 4)


def test_an_example_is_mirrored_with_its_headings():
    row = ((100.0, 200.0, 30.0, 1.0), (120.0, 80.0, 100.0, 250.0, 300.0, -170.0))
    assert regressed.mirrored(*row) == ((260.0, 200.0, -30.0, 1.0),
                                        (240.0, 80.0, 80.0, 110.0, 300.0, -10.0))
    both = regressed.both_halves([row])
    assert len(both) == 2 and both[0][0] == row[0]
    assert both[0][1][2:4] == pytest.approx((math.cos(math.radians(100.0)),
                                            math.sin(math.radians(100.0))))


def test_another_field_is_scaled_to_that_of_the_examples():
    field, questions = kelpie.FIELDS['2004'], []
    model = regressed.RegressedPositions()
    model.regression = SimpleNamespace(
        answer=lambda *one: questions.append(one) or (180.0, 270.0, 0.0, 1.0))
    assert model.place(field, (72.5, 330.0), 12.0, True, 1) == pytest.approx((145.0, 220.0, 90.0))
    assert model.place(field, (72.5, 330.0), 12.0, False, 0)[2] == pytest.approx(90.0)
    assert questions[0][0] == pytest.approx((90.0, 405.0, 12.0, 1.0))
    assert questions[1][0] == pytest.approx((90.0, 405.0, 12.0, 0.0))
    assert [one[1:] for one in questions] == [(4, 8), (0, 4)]


# The ball on a string

@pytest.mark.parametrize('off', [(19.9, 0.0), (0.0, -19.9), (14.0, 14.0)])
def test_a_ball_within_20_cm_moves_no_place(off):
    string = positions.BallOnString()
    string.update((180.0, 300.0))
    assert string.update((180.0 + off[0], 300.0 + off[1])) == (180.0, 300.0)


@pytest.mark.parametrize('off, follows', [((30.0, 0.0), (10.0, 0.0)), ((0.0, -50.0), (0.0, -30.0)),
                                          ((30.0, 40.0), (18.0, 24.0))])
def test_a_ball_that_is_farther_off_is_followed_20_cm_behind(off, follows):
    string = positions.BallOnString()
    string.update((180.0, 300.0))
    place = string.update((180.0 + off[0], 300.0 + off[1]))
    assert place == pytest.approx((180.0 + follows[0], 300.0 + follows[1]))


# Places for a pass, and passes

@pytest.mark.parametrize('ball, place', [((100.0, 128.0), (180.0, 120.0)),
                                         ((100.0, 132.0), (107.27, 120.0)),
                                         ((260.0, 132.0), (252.73, 120.0)),
                                         ((100.0, 60.0), (180.0, 120.0))])
def test_a_ball_less_than_10_cm_before_the_defender_leaves_it_where_the_tree_has_it(ball, place):
    found = positions_passing.covering(world().field, (180.0, 120.0), ball)
    assert found == pytest.approx(place, abs=0.01)


def test_a_place_for_a_pass_is_chosen_in_every_tenth_frame():
    made, home = world(), Home()
    made.task.passing = True
    first = home.update(made, S, (100.0, 200.0), ())
    places = [home.update(made, S, (260.0, 400.0), ()) for _ in range(10)]
    assert places[:9] == [first] * 9 and places[9] != first


def test_without_a_ball_no_place_for_a_pass_is_sought():
    made, home = world(), Home()
    made.task.passing = True
    assert home.update(made, S, None, ()) == pytest.approx((252.0, 351.0))


def test_a_place_of_before_within_80_cm_of_the_trees_is_a_choice():
    made = world(180.0, 200.0)
    place, ball = (180.0, 300.0), (180.0, 135.0)
    made.opponents = [opponent(180.0, 215.0)]     # in the way of each pass but to far aside
    for away, kept in ((79.0, True), (81.0, False)):
        before = 180.0 - away, 300.0
        assert (positions_passing.moved(made, S, place, ball, before) == before) is kept


@pytest.mark.parametrize('start', [(100.0, 208.0), (260.0, 208.0), (150.0, 100.0)])
@pytest.mark.parametrize('heading, asked', [
    (90.0, kelpie.HARD_FORWARD), (60.0, kelpie.HARD_FORWARD), (130.0, kelpie.HARD_FORWARD),
    (90.0, kelpie.UPENN_LEFT), (90.0, kelpie.UPENN_RIGHT), (60.0, kelpie.UPENN_LEFT)])
def test_a_pass_goes_from_the_ball_along_the_kicks_way(start, heading, asked):
    made = world(*start, heading)
    _, direction, _, distance, _ = kick_table.held_outcome(asked)
    angle = math.radians(heading + direction)
    end = start[0] + distance * math.cos(angle), start[1] + distance * math.sin(angle)
    made.teammates = [mate(3, S, at=end)]
    utility, kick, player = passing.best(made, start)
    way = kick_table.held_outcome(kick)[1]
    assert player == 3 and abs(way - direction) < 25.0
    chance = kick_table.held_outcome(kick)[0]
    assert utility == pytest.approx(chance * passing.utility_at(made, end))


def test_of_two_mates_the_better_placed_one_gets_the_pass():
    made = world(100.0, 200.0)
    _, direction, _, distance, _ = kick_table.held_outcome(kelpie.HARD_FORWARD)
    places = [(100.0, 200.0 + distance), (100.0, 200.0 + 0.7 * distance)]
    for near, far in ((2, 3), (3, 2)):
        made.teammates = [mate(far, S, at=places[0]), mate(near, S, at=places[1])]
        assert passing.best(made, (100.0, 200.0))[2] == far


@pytest.mark.parametrize('place, gets_it', [((100.0, 359.0), True), ((100.0, 361.0), False)])
def test_a_ball_that_rests_within_60_cm_of_a_mate_is_fetched(place, gets_it):
    way = Lane('', (100.0, 100.0), (100.0, 300.0), 25.0)
    assert passing.arrives(way, place) is gets_it


@pytest.mark.parametrize('gain, before, passes', [
    (0.07, 0, False), (0.09, 0, True), (0.07, 4, False), (0.01, 3, True), (-0.01, 3, False)])
def test_a_pass_begins_when_it_is_worth_0_08_more_than_the_own_kick(monkeypatch, gain, before,
                                                                   passes):
    made = world(180.0, 300.0)
    made.task.passing, made.teammates = True, [mate(3, S, at=(180.0, 450.0))]
    dribble = GrabDribble(Memory(), None)
    dribble.hold, dribble.aim = Hold(made, made.time_s), Aim()
    dribble.aim.gap = (12.0, -12.0)
    own = max(kick_map_choice.utility_of(made, kick, (12.0, -12.0), 0.0)
              for kick in kick_table.kicks(True) if kelpie.KICKS[kick].mirror == kick)
    monkeypatch.setattr(passing, 'best', lambda *asked: (own + gain, kelpie.WEDGE, 3))
    choice = HeldChoice(Memory(), Contested())
    choice.pass_to = before
    found = choice.pass_on(made, dribble)
    assert (found is not None) is passes
    if passes:
        assert found[0] == kelpie.WEDGE and choice.pass_to == 3
