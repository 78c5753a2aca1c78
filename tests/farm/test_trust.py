# SPDX-License-Identifier: Apache-2.0
# How often the sequential test errs, on 2-minute matches of one against one that were played
# (stored.jsonl, a league between two names of the same behaviours).
import random
from pathlib import Path

import pytest
from farm.plan import Plan
from farm.store import Store
from farm.trust import DrawnPairs, mean_without, share_for, stored_matches, stored_values, trust
from farm.work import Trouble

STORED = stored_matches(Path(__file__).parent / 'stored.jsonl')
PLAN = Plan('a', 'b', 0, 2.0, '4v4', 'percepts', 'value', 0.0, 0.004)


def no_more_than(share, runs):
    """A share that 200 runs may show of a true one of 5 %: two standard deviations more."""
    return share <= 0.05 + 2.0 * (0.05 * 0.95 / runs) ** 0.5


@pytest.mark.parametrize('by, low, high', [('goals', 0.0, 0.5), ('score', 0.5, 0.6)])
def test_an_equal_team_is_accepted_and_a_better_one_rejected_once_in_twenty_tests(by, low, high):
    told = trust(STORED, by, low, high, 200, 1)
    assert no_more_than(told['equal']['accepted'], 200)
    assert no_more_than(told['better']['rejected'], 200)
    for who in ('equal', 'better', 'weaker'):
        assert told[who]['accepted'] + told[who]['rejected'] == 1.0


@pytest.mark.parametrize('by, low, high', [('goals', 0.0, 0.5), ('score', 0.5, 0.6)])
def test_a_weaker_team_is_never_accepted_and_sooner_rejected_than_an_equal_one(by, low, high):
    told = trust(STORED, by, low, high, 200, 2)
    assert told['weaker']['rejected'] == 1.0
    assert told['weaker']['pairs'] < told['equal']['pairs']


def test_the_mean_without_some_goals_is_what_drawn_matches_come_to():
    for by, mean in (('goals', 0.7), ('score', 0.6), ('score', 0.42), ('goals', -0.3)):
        drawn = DrawnPairs(STORED, by, mean, 'seed')
        pairs = [drawn.pair() for _ in range(20000)]
        assert sum(pairs) / len(pairs) == pytest.approx(mean, abs=0.04)


def test_with_all_goals_both_sides_are_equal_and_without_any_the_other_has_all_of_them():
    assert mean_without([(3, 1), (0, 2)], 'goals', 0.0) == pytest.approx(0.0)
    assert mean_without([(3, 1), (0, 2)], 'score', 0.0) == pytest.approx(0.5)
    assert mean_without([(3, 1), (0, 2)], 'goals', 1.0) == pytest.approx(1.5)
    # 3, 1 and 2 goals against none win; 0 against none is a draw
    assert mean_without([(3, 1), (0, 2)], 'score', 1.0) == pytest.approx(0.875)


def test_half_of_the_goals_against_a_side_that_scores_as_many_are_half_of_them():
    assert share_for([(2, 2), (4, 4)], 'goals', 1.5) == pytest.approx(0.5)
    with pytest.raises(Trouble, match='no team is so weak'):
        share_for([(2, 2), (4, 4)], 'goals', 3.5)


@pytest.mark.parametrize('text, complaint', [
    ('', '0 matches'), ('{}\n', '0 matches'), ('no json\n', 'no journal'),
    ('{}\n{"trouble": "", "red_goals": 1}\n', 'results without goals'),
    ('{}\n' + '{"trouble": "", "red_goals": 1, "blue_goals": 0}\n' * 7, '7 matches, at least 8'),
    ('{}\n' + '{"trouble": "void"}\n' * 9, '0 matches')])
def test_too_few_results_or_none_are_refused_in_one_line(tmp_path, text, complaint):
    path = tmp_path / 'league.jsonl'
    path.write_text(text)
    with pytest.raises(Trouble, match=complaint):
        stored_matches(path)


def stored_pairs(folder, values):
    """A store in which each value is a pair's, from a test of one seed each."""
    store = Store(folder / 'farm.sqlite', writes=True)
    store.begin('t', PLAN._asdict())
    for seed, value in enumerate(values):
        for colour, sign in (('red', 1.0), ('blue', -1.0)):
            store.add('t', seed, colour, {'trouble': '', 'red_goals': 0, 'blue_goals': 0,
                                          'value': sign * value})
    store.close()
    return folder / 'farm.sqlite'


def test_by_value_an_equal_team_is_accepted_about_as_seldom_as_is_meant(tmp_path):
    draw = random.Random(5)
    pairs = stored_values(stored_pairs(tmp_path, [draw.gauss(0.02, 0.03) for _ in range(200)]))
    told = trust(pairs, 'value', 0.0, 0.01, 200, 3)
    assert told['equal']['accepted'] <= 0.09 and told['weaker']['rejected'] == 1.0
    assert told['better']['accepted'] >= 0.91


def test_values_are_of_pairs_and_too_few_of_them_are_refused(tmp_path):
    with pytest.raises(Trouble, match='7 pairs with a value, at least 8'):
        stored_values(stored_pairs(tmp_path, [0.1] * 7))


@pytest.mark.parametrize('goals', ['"x"', '-1', '1.5', 'null'])
def test_results_whose_goals_are_none_are_refused_in_a_line(tmp_path, goals):
    journal = tmp_path / 'league.jsonl'
    row = f'{{"trouble": "", "red_goals": {goals}, "blue_goals": 0}}\n'
    journal.write_text('{}\n' + 9 * row)
    with pytest.raises(Trouble, match='results without goals'):
        stored_matches(journal)
