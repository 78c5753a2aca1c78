# SPDX-License-Identifier: Apache-2.0
# What is tried next: each sampler finds a planted optimum, and asks the same when told the same.
import pytest
from farm.samplers import CLIMB, CMAES, TPE, sampler_of
from farm.vector import defaults, described

FOUND = described('dribble')
CARRY_TO = 'behaviour.constants.dribble.carryTo'


def figure(vector):
    return -abs(vector[CARRY_TO] - 110.0)


def path_of(kind, seed, trials=40):
    if kind != CLIMB:
        pytest.importorskip('optuna', reason='no Optuna: tools/install farm')
    sampler = sampler_of(kind, FOUND, seed)
    path = []
    for _ in range(trials):
        vector = sampler.asked()
        path.append(vector)
        sampler.told(vector, figure(vector))
    return path


@pytest.mark.parametrize('kind', [TPE, CMAES, CLIMB])
def test_the_first_vector_is_that_of_the_defaults_and_all_are_in_their_ranges(kind):
    path = path_of(kind, 3)
    assert path[0] == defaults(FOUND)
    assert all(one.low <= vector[one.key] <= one.high for vector in path for one in FOUND)
    assert all(isinstance(vector[one.key], int) == one.counts for vector in path for one in FOUND)


@pytest.mark.parametrize('kind', [TPE, CMAES, CLIMB])
def test_a_planted_optimum_is_come_near(kind):
    best = [max(map(figure, path_of(kind, seed, 120))) for seed in range(3)]
    assert sum(best) / 3 > -15.0       # the defaults are 45 away


@pytest.mark.parametrize('kind', [TPE, CMAES, CLIMB])
def test_told_the_same_it_asks_the_same(kind):
    assert path_of(kind, 5, 15) == path_of(kind, 5, 15) != path_of(kind, 6, 15)
