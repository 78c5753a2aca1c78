# SPDX-License-Identifier: Apache-2.0
# The sequential test: its ratio against values worked out by hand, and what it decides.
import math
import random

import pytest
from farm.sprt import (ACCEPTED, BOUND, LEAST, OPEN, REJECTED, SAME, SCORES, Bounds, SequentialTest,
                       interval_at_any_time, likeliest_shares, normal_llr, pentanomial_llr,
                       remaining_pairs)

GOALS = Bounds(0.0, 0.5)
SCORE = Bounds(0.5, 0.55, True)


def fed(bounds, observations):
    test = SequentialTest(bounds)
    for observation in observations:
        test.add(observation)
    return test


def test_the_bound_is_that_of_five_per_cent_on_either_side():
    assert BOUND == pytest.approx(2.9444, abs=1e-4)


def test_the_normal_ratio_is_that_of_two_normal_densities():
    # 40 pairs of mean 0.3 and variance 2: 40 (0.5 - 0) (0.6 - 0 - 0.5) / (2 x 2) = 0.5
    assert normal_llr(40, 0.3, 2.0, GOALS) == pytest.approx(0.5)
    values = [0.3 + offset for offset in (-2.0, 2.0)] * 20
    densities = sum(((v - 0.0) ** 2 - (v - 0.5) ** 2) / (2 * 4.0) for v in values)
    assert normal_llr(40, 0.3, 4.0, GOALS) == pytest.approx(densities)


def test_a_mean_in_the_middle_of_both_hypotheses_says_nothing():
    assert normal_llr(1000, 0.25, 1.0, GOALS) == 0.0
    for counts in ([0, 0, 0, 0, 0], [3, 7, 5, 7, 3]):
        assert pentanomial_llr(counts, Bounds(0.4, 0.6, True)) == pytest.approx(0.0, abs=1e-9)


def test_the_ratio_of_two_kinds_of_pairs_is_the_binomial_one():
    """With losses and wins alone there is one distribution of each mean, and nothing to fit."""
    by_hand = 30 * math.log(0.6 / 0.5) + 20 * math.log(0.4 / 0.5)
    got = pentanomial_llr([20, 0, 0, 0, 30], Bounds(0.5, 0.6, True))
    assert got == pytest.approx(by_hand, abs=0.01)      # kinds that did not come count 0.001 pairs


def test_the_likeliest_distribution_has_the_mean_that_was_asked_for_and_sums_to_one():
    shares = [0.1, 0.2, 0.4, 0.2, 0.1]
    for mean in (0.3, 0.5, 0.55, 0.9):
        fitted = likeliest_shares(shares, SCORES, mean)
        assert sum(fitted) == pytest.approx(1.0)
        assert sum(p * v for p, v in zip(fitted, SCORES)) == pytest.approx(mean)


def test_no_other_distribution_of_that_mean_is_likelier():
    shares = [0.15, 0.2, 0.3, 0.25, 0.1]
    fitted = likeliest_shares(shares, SCORES, 0.6)

    def log_likelihood(distribution):
        return sum(p * math.log(q) for p, q in zip(shares, distribution))
    for i, j, k in ((0, 1, 2), (1, 2, 3), (2, 3, 4), (0, 2, 4)):
        for step in (1e-3, -1e-3):      # keeps sum and mean: k - j is as far as j - i
            other = list(fitted)
            other[i] += step
            other[j] -= 2 * step
            other[k] += step
            assert log_likelihood(other) < log_likelihood(fitted)


def test_the_exact_ratio_is_near_the_normal_one_where_hypotheses_are_close():
    counts = [10, 40, 100, 60, 20]
    n = sum(counts)
    mean = sum(c * v for c, v in zip(counts, SCORES)) / n
    variance = sum(c * (v - mean) ** 2 for c, v in zip(counts, SCORES)) / n
    exact = pentanomial_llr(counts, Bounds(0.5, 0.52, True))
    assert exact == pytest.approx(normal_llr(n, mean, variance, Bounds(0.5, 0.52)), rel=0.05)


def test_the_better_side_is_accepted_and_the_equal_one_rejected():
    better = [0.75, 0.5, 1.0, 0.5] * 100
    equal = [0.75, 0.25, 0.5, 0.5] * 100
    assert fed(SCORE, better).decision == ACCEPTED
    assert fed(SCORE, equal).decision == REJECTED
    assert fed(GOALS, [1.0, 0.0, 2.0, -1.0] * 100).decision == ACCEPTED
    assert fed(GOALS, [1.0, -1.0, 2.0, -2.0] * 100).decision == REJECTED


def test_nothing_is_decided_before_sixteen_pairs_however_clear_they_are():
    assert LEAST == 16
    assert fed(SCORE, [1.0] * 15).decision == OPEN
    assert fed(GOALS, [3.0, 2.0] * 7 + [3.0]).decision == OPEN
    assert fed(GOALS, [3.0, 2.0] * 8).decision == ACCEPTED


def test_what_comes_after_the_decision_changes_nothing():
    once = fed(GOALS, [3.0, 2.0] * 8)
    more = fed(GOALS, [3.0, 2.0] * 8 + [-9.0] * 50)
    assert (more.count, more.mean, more.llr, more.decision) == (
        once.count, once.mean, once.llr, once.decision)


def test_pairs_that_are_all_the_same_decide_when_another_kind_is_rarer_than_one_in_twenty():
    """0.95 to the power of 63 is 0.04. So end two names of the same behaviours, whose matches of a
    seed are the same match."""
    assert fed(GOALS, [0.0] * 63).decision == OPEN
    assert fed(GOALS, [0.0] * 64).decision == REJECTED
    assert fed(GOALS, [1.0] * 64).decision == ACCEPTED
    assert fed(GOALS, [0.0] * 20).remaining() == 44
    assert math.isinf(fed(GOALS, [0.0] * 10).remaining())


def test_mean_and_variance_are_those_of_the_pairs():
    test = fed(GOALS, [1.0, 2.0, 4.0])
    assert test.mean == pytest.approx(7 / 3) and test.variance == pytest.approx(7 / 3)


def test_the_way_to_go_is_what_tests_take_that_are_drawn():
    """Mean 0.4 and variance 1, from an LLR of 1: the mean length of 2000 random walks."""
    draw = random.Random(3)
    lengths = []
    for _ in range(2000):
        llr, length = 1.0, 0
        while abs(llr) < BOUND:
            llr += 0.5 * (2 * draw.gauss(0.4, 1.0) - 0.5) / 2.0
            length += 1
        lengths.append(length)
    expected = remaining_pairs(1.0, 0.4, 1.0, GOALS)
    drawn = sum(lengths) / len(lengths)
    assert expected < drawn < 1.25 * expected + 2      # a walk of whole steps goes over the bound


def test_the_way_to_go_has_no_step_where_the_drift_is_none():
    near = [remaining_pairs(0.5, 0.25 + d, 1.0, GOALS) for d in (-1e-4, 0.0, 1e-4)]
    assert max(near) - min(near) < 0.01 * max(near)
    assert remaining_pairs(3.0, 0.4, 1.0, GOALS) == 0.0


def looks_at(seed, mean):
    """(count, mean, variance) after each of 300 drawn pairs from the sixteenth on."""
    draw = random.Random(seed)
    total = squares = 0.0
    for count in range(1, 301):
        observation = draw.gauss(mean, 1.5)
        total, squares = total + observation, squares + observation * observation
        if count >= 16:
            yield count, total / count, (squares - total * total / count) / (count - 1)


@pytest.mark.parametrize('mean, step', [(0.9, 1e-4), (0.1, 1e-4), (0.625, 2e-4), (0.5, 1e-9),
                                        (-50.0, 1.0), (50.0, 1.0)])
def test_the_way_to_go_is_a_number_for_any_mean_and_bounds(mean, step):
    bounds = Bounds(0.5 - step, 0.5 + step)
    straight = BOUND * 1e-3 / (2.0 * step * abs(mean - 0.5)) if mean != 0.5 else math.inf
    to_go = remaining_pairs(0.0, mean, 1e-3, bounds)
    assert 0.0 < to_go <= 1.0001 * straight     # no walk takes longer than a straight one


def test_the_interval_holds_the_mean_at_every_look_in_95_of_100_tests():
    missed = 0
    for seed in range(400):
        intervals = [interval_at_any_time(*look) for look in looks_at(seed, 0.2)]
        missed += any(not low <= 0.2 <= high for _, low, high in intervals)
    assert missed <= 0.05 * 400


def test_the_interval_is_open_while_nothing_is_known_of_the_spread():
    assert interval_at_any_time(1, 0.5, 0.0)[1:] == (-math.inf, math.inf)
    assert interval_at_any_time(20, 0.5, 0.0)[1:] == (-math.inf, math.inf)


def test_the_interval_is_half_as_wide_with_four_times_the_pairs_or_a_little_more():
    few, many = (interval_at_any_time(n, 0.0, 1.0).high for n in (100, 400))
    assert 0.5 * few < many < 0.6 * few


def test_pairs_that_are_nearly_all_the_same_decide_nothing_before_they_are_many():
    test = SequentialTest(Bounds(0.0, 0.004))
    for number in range(SAME - 1):
        test.add(1e-9 if number % 2 else 0.0)
        assert test.decision == OPEN
    test.add(0.0)
    assert test.decision == REJECTED


def test_four_pairs_that_differ_are_enough_to_know_a_spread():
    test = SequentialTest(Bounds(0.0, 1.0))
    for number in range(LEAST):
        test.add(-0.5 if number < 4 else 0.0)
    assert test.decision == REJECTED
