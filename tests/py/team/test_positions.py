# SPDX-License-Identifier: Apache-2.0
"""Where striker, supporter and defender stand: the tables of algorithms 4.7 to 4.9, the regression
over examples with its k-d tree, and the ball on a string."""
import math
import random
from types import SimpleNamespace

import kelpie
import pytest
from data.examples import EXAMPLES
from decisions import positions, positions_regression as regressed
from decisions.home import Home
from lib import regression
from lib.kd_tree import KdTree, squared
from situations import world

FIELD = kelpie.FIELDS['2006']


# The trees (checklist E5)

@pytest.mark.parametrize('ball_y, y', [
    (0, 350), (269, 350), (270, 270), (322, 270), (325, 273), (359.9, 307.9), (360, 280),
    (400, 320), (450, 370), (540, 460)])
def test_a_striker_stands_so_far_up_field(ball_y, y):
    assert positions.striker(FIELD, (100.0, ball_y)) == (300.0, pytest.approx(y))


def test_a_striker_stands_on_the_other_side_than_the_ball():
    assert positions.striker(FIELD, (181.0, 0.0))[0] == 60.0
    assert positions.striker(FIELD, (179.0, 0.0))[0] == 300.0


@pytest.mark.parametrize('ball, place', [
    ((180, 300), (180, 220)), ((0, 300), (70, 220)), ((360, 300), (290, 220)),
    ((180, 0), (180, 120)), ((180, 540), (180, 460))])
def test_a_supporter_stands_behind_the_attacker(ball, place):
    assert positions.supporter(FIELD, ball) == place


@pytest.mark.parametrize('ball, place', [
    ((0, 200), (120, 85)), ((180, 200), (180, 85)), ((360, 200), (240, 85)),
    ((180, 300), (180, 180)), ((0, 400), (50, 280)), ((125.9, 400), (50, 280)),
    ((126, 400), (153, 280)),
    ((180, 400), (180, 280)), ((234, 400), (207, 280)), ((234.1, 400), (310, 280)),
    ((360, 400), (310, 280))])
def test_a_defender_stands_between_ball_and_goal_or_behind_the_drop_in_point(ball, place):
    assert positions.defender(FIELD, ball) == pytest.approx(place)


def test_no_place_is_in_the_own_box_or_off_any_field():
    for field in kelpie.FIELDS.values():
        for x in range(0, round(field.width) + 1, 20):
            for y in range(0, round(field.length) + 1, 20):
                for place in positions.PLACES.values():
                    px, py = place(field, (float(x), float(y)))
                    assert field.box_depth < py < field.length and 0.0 < px < field.width


@pytest.mark.parametrize('role, place', [
    (kelpie.STRIKER, (252.0, 351.0)), (kelpie.SUPPORTER, (180.0, 216.0)),
    (kelpie.DEFENDER, (180.0, 118.8))])
@pytest.mark.parametrize('by', [kelpie.POSITIONS_BY_TREE, kelpie.POSITIONS_BY_REGRESSION])
def test_without_a_ball_each_waits_in_its_own_part_of_the_field(role, place, by):
    made = world()
    made.task.positions = by
    assert Home().update(made, role, None, ()) == pytest.approx(place)


def test_a_ball_on_a_string_does_not_follow_noise_and_follows_a_ball_that_rolls():
    string, chance = positions.BallOnString(), random.Random(1)
    first = string.update((126.0, 400.0))
    for _ in range(300):
        assert string.update((126.0 + chance.uniform(-6, 6), 400.0)) == first
    for step in range(100):
        at = string.update((126.0 + step, 400.0))
    assert at == pytest.approx((225.0 - positions.STRING, 400.0))
    assert string.update(None) == at


# The k-d tree

@pytest.mark.parametrize('count', [1, 3, 40, 1000])
def test_a_k_d_tree_finds_what_looking_at_all_finds(count):
    chance = random.Random(count)
    points = [tuple(chance.uniform(-1, 1) for _ in range(4)) for _ in range(count)]
    points += points[:2]  # some lie on one another
    tree = KdTree(points)
    for _ in range(200):
        query = tuple(chance.uniform(-1.2, 1.2) for _ in range(4))
        every = sorted((squared(point, query), i) for i, point in enumerate(points))
        assert tree.nearest(query, 5) == every[:5]
        assert tree.within(query, 0.7) == [pair for pair in every if pair[0] <= 0.49]


def test_an_empty_tree_finds_nothing():
    assert KdTree([]).nearest((0.0,), 3) == [] and KdTree([]).within((0.0,), 3.0) == []


def test_the_nearest_of_many_points_are_found_without_looking_at_most():
    class Counted(tuple):
        looks = 0

        def __iter__(self):
            Counted.looks += 1
            return super().__iter__()
    chance = random.Random(2)
    tree = KdTree([Counted(chance.random() for _ in range(3)) for _ in range(4000)])
    Counted.looks = 0
    for _ in range(50):
        tree.nearest(tuple(chance.random() for _ in range(3)), 3)
    assert Counted.looks / 50 < 200


# Regression

def test_the_kernel_is_that_of_equation_4_11():
    assert [round(regression.kernel(d), 3) for d in (0.0, 1.0, 2.0)] == [1.0, 0.368, 0.018]


def mean(model, inputs):
    """Equation 4.3, the weighted mean of the examples that count: what a regression must beat."""
    near = model.neighbours(model.scaled(inputs))
    total = sum(weight for weight, _, _ in near)
    return sum(weight * outputs[0] for weight, _, outputs in near) / total


def test_a_linear_function_comes_out_exactly_and_its_mean_does_not():
    chance = random.Random(3)

    def linear(x, y, z):
        return 3.0 + 2.0 * x - y + 0.5 * z, x - 7.0
    inputs = [tuple(chance.uniform(0, 100) for _ in range(3)) for _ in range(60)]
    model = regression.Regression([(one, linear(*one)) for one in inputs], (50, 50, 50), 0.6)
    off = 0.0
    for _ in range(100):
        query = tuple(chance.uniform(10, 90) for _ in range(3))
        assert model.answer(query) == pytest.approx(linear(*query), abs=1e-6)
        off = max(off, abs(mean(model, query) - linear(*query)[0]))
    assert off > 1.0


def test_where_the_neighbours_settle_no_slope_their_mean_is_the_answer():
    model = regression.Regression([((0.0, 0.0), (10.0,)), ((0.0, 0.0), (20.0,))], (1, 1), 1.0)
    assert model.answer((0.1, 0.0)) == pytest.approx([15.0], abs=1e-3)
    assert model.answer((50.0, 0.0)) == pytest.approx([15.0], abs=1e-2)


def test_the_weighted_mean_has_the_least_weighted_error():
    """Equations 4.3 and 4.4."""
    model = regression.Regression([((x,), (x * x,)) for x in (0.0, 0.4, 1.1, 1.5)], (1,), 1.0)
    near = model.neighbours((0.6,))

    def error(value):
        return sum(weight * (value - outputs[0]) ** 2 for weight, _, outputs in near)
    best = mean(model, (0.6,))
    assert error(best) < min(error(best + 0.01), error(best - 0.01))


@pytest.fixture(scope='module')
def by_examples():
    return regressed.RegressedPositions()


@pytest.mark.parametrize('row', EXAMPLES[:4])
def test_the_four_cases_of_figure_4_7_come_out_as_they_were_put_in(by_examples, row):
    (x, y, angle, attacks), out = row
    defender, last = by_examples.answer(FIELD, (x, y), angle, attacks)
    assert defender[:2] == pytest.approx(out[:2], abs=10.0)
    assert last[:2] == pytest.approx(out[3:5], abs=10.0)
    assert math.cos(math.radians(last[2] - out[5])) > 0.97


def test_a_mirrored_question_has_the_mirrored_answer(by_examples):
    chance = random.Random(4)
    for _ in range(200):
        ball = chance.uniform(0, 360), chance.uniform(0, 540)
        angle, attacks = chance.uniform(-180, 180), chance.random() < 0.5
        one = by_examples.answer(FIELD, ball, angle, attacks)
        two = by_examples.answer(FIELD, (360.0 - ball[0], ball[1]), -angle, attacks)
        for (x, y, heading), (mx, my, mheading) in zip(one, two):
            assert (mx, my) == pytest.approx((360.0 - x, y), abs=1e-6)
            assert math.cos(math.radians(180.0 - heading - mheading)) == pytest.approx(1.0)


def test_every_answer_lies_on_the_field_before_the_own_box(by_examples):
    for x in range(0, 361, 30):
        for y in range(0, 541, 30):
            for angle in (-150.0, -40.0, 0.0, 90.0):
                for attacks in (False, True):
                    for px, py, _ in by_examples.answer(FIELD, (x, y), angle, attacks):
                        assert 0.0 < px < 360.0 and FIELD.box_depth < py < 540.0


@pytest.mark.parametrize('attacker, angle', [
    ((180, 100), 0.0), ((100, 200), -90.0), ((260, 200), 90.0), ((180, 300), 180.0),
    ((180, 190), 0.0), ((199, 200), 0.0), ((201, 200), 90.0)])
def test_the_attackers_angle_counts_left_of_up_field(attacker, angle):
    assert abs(regressed.attacker_angle(attacker, (180, 200))) == abs(angle)
    assert regressed.attacker_angle(attacker, (180, 200)) == pytest.approx(angle) or \
        abs(angle) == 180.0


@pytest.mark.parametrize('holds, opponents, ball_y, yes', [
    (True, [(180, 200)], 200, True), (False, [(180, 210)], 200, False),
    (False, [(180, 290)], 200, True), (False, [], 200, False), (False, [], 300, True)])
def test_a_team_attacks_that_has_the_ball_or_is_nearer(holds, opponents, ball_y, yes):
    others = [kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y)) for x, y in opponents]
    assert regressed.attacks((180, ball_y), (180, 140), holds, others, FIELD) == yes


@pytest.mark.parametrize('answer, place', [
    ((-5.0, -5.0), (20.0, 20.0)), ((400.0, 600.0), (340.0, 520.0))])
def test_a_place_by_examples_is_20_cm_inside_the_lines_and_before_the_own_box(answer, place):
    model = regressed.RegressedPositions(EXAMPLES[:4])
    model.regression = SimpleNamespace(answer=lambda *asked: (*answer, 1.0, 0.0))
    before_box = FIELD.box_depth if answer[1] < 0.0 else 0.0
    assert model.place(FIELD, (180.0, 270.0), 0.0, True, 0)[:2] == (place[0], place[1] + before_box)
