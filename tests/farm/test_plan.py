# SPDX-License-Identifier: Apache-2.0
# What a test is and what its results say: pairs in the order of seeds, void ones left out.
import pytest
from farm.plan import Judged, Plan, checked_bounds, figure, matches_to_play, plan_of
from farm.work import Trouble

PLAN = Plan('teams/a', 'teams/b', 10, 2.0, '4v4', 'images', 'score', 0.5, 0.6, 'version 1')
GOALS = PLAN._replace(by='goals', low=0.0, high=0.5)


def won(red, blue, **more):
    return {'trouble': '', 'red_goals': red, 'blue_goals': blue, **more}


VOID = {'trouble': 'the world died'}


def judged(results, plan=PLAN):
    made = Judged(plan)
    made.take(results)
    return made


def test_the_first_side_is_red_in_one_match_and_blue_in_the_other():
    assert PLAN.match(12, 'red')[:3] == ('teams/a', 'teams/b', 12)
    assert PLAN.match(12, 'blue')[:3] == ('teams/b', 'teams/a', 12)


def test_scenes_come_in_turn_and_the_same_in_both_colours():
    plan = PLAN._replace(scenes=('edge', 'scrum'))
    assert [plan.match(seed, 'red').scene for seed in (10, 11, 12)] == ['edge', 'scrum', 'edge']
    assert plan.match(11, 'blue').scene == 'scrum' and PLAN.match(11, 'red').scene == ''


@pytest.mark.parametrize('red, blue, colour, score, goals', [
    (3, 1, 'red', 1.0, 2.0), (3, 1, 'blue', 0.0, -2.0), (2, 2, 'red', 0.5, 0.0),
    (0, 1, 'blue', 1.0, 1.0)])
def test_a_match_seen_by_the_first_side(red, blue, colour, score, goals):
    assert figure(won(red, blue), colour, 'score') == score
    assert figure(won(red, blue), colour, 'goals') == goals


def test_value_is_reds_and_its_opposite_blues():
    assert figure(won(0, 0, value=0.3), 'red', 'value') == 0.3
    assert figure(won(0, 0, value=0.3), 'blue', 'value') == -0.3
    with pytest.raises(Trouble, match='have no value'):
        figure(won(0, 0), 'red', 'value')


def test_a_pair_is_the_mean_of_its_two_matches():
    one = judged({(10, 'red'): won(3, 0), (10, 'blue'): won(1, 2)}, GOALS)
    assert one.test.mean == 2.0 and one.goals == [5, 1] and one.pairs == 1


def test_an_advantage_of_a_colour_helps_nobody():
    results = {(seed, colour): won(2, 0) for seed in range(10, 30) for colour in ('red', 'blue')}
    assert judged(results).test.mean == 0.5 and judged(results, GOALS).test.mean == 0.0


def test_pairs_count_up_to_the_first_seed_that_lacks_a_match():
    results = {(seed, colour): won(1, 0) for seed in (10, 11, 13) for colour in ('red', 'blue')}
    assert judged(results).pairs == 2
    results[12, 'red'] = won(0, 0)
    assert judged(results).pairs == 2
    results[12, 'blue'] = won(0, 0)
    assert judged(results).pairs == 4


def test_results_in_any_order_make_the_same_decision():
    draws = [won((3 * seed) % 4, seed % 3) for seed in range(100)]
    results = {(10 + i, colour): draws[i] if colour == 'red' else won(0, 1)
               for i in range(100) for colour in ('red', 'blue')}
    at_once = judged(results)
    piece_by_piece, known = Judged(PLAN), {}
    for key in sorted(results, key=lambda key: (key[0] * 37) % 101):
        known[key] = results[key]
        piece_by_piece.take(known)
    assert at_once.decided and at_once.pairs < 100
    assert (piece_by_piece.pairs, piece_by_piece.test.llr) == (at_once.pairs, at_once.test.llr)


def test_a_pair_with_a_void_match_counts_for_nothing_and_does_not_hold_up_the_others():
    results = {(10, 'red'): won(9, 0), (10, 'blue'): VOID, (11, 'red'): won(1, 1),
               (11, 'blue'): won(1, 1)}
    made = judged(results)
    assert made.voids == 1 and made.pairs == 2
    assert made.test.count == 1 and made.test.mean == 0.5 and made.goals == [2, 2]


def test_matches_to_play_are_those_without_a_result_in_the_order_of_seeds():
    done = {(10, 'blue'), (12, 'red')}
    wanted = list(matches_to_play(PLAN, Judged(PLAN), done, 3))
    assert wanted == [(10, 'red'), (11, 'red'), (11, 'blue'), (12, 'blue')]


@pytest.mark.parametrize('change', [
    {'first': 'teams/c'}, {'seed': 11}, {'minutes': 3.0}, {'robots': '2v2'},
    {'world': 'physical'}, {'scenes': ('edge',)}, {'rules': '2005'},
    {'by': 'goals'}, {'low': 0.4}, {'high': 0.7}, {'about': 'version 2'}])
def test_another_plan_is_another_test(change):
    assert PLAN._replace(**change).id != PLAN.id
    assert plan_of(PLAN._asdict()).id == PLAN.id


@pytest.mark.parametrize('by, words, bounds', [
    ('score', '', (0.5, 0.55)), ('goals', '', (0.0, 0.25)), ('value', '', (0.0, 0.1)),
    ('value', '-0.1,0.2', (-0.1, 0.2))])
def test_bounds_are_those_asked_for_or_the_usual_ones(by, words, bounds):
    assert checked_bounds(by, words) == bounds


def test_scenes_are_short_and_their_usual_bounds_narrow():
    assert checked_bounds('value', '', True) == (0.0, 0.004)
    assert checked_bounds('goals', '', True) == (0.0, 0.02)
    assert checked_bounds('score', '', True) == checked_bounds('score', '')


@pytest.mark.parametrize('by, words', [
    ('score', '0.5,1.0'), ('score', '0,0.5'), ('goals', '1,1'), ('goals', '2,1'), ('goals', 'a,b'),
    ('goals', '1'), ('goals', '1,2,3'), ('goals', 'nan,1'), ('value', '0.1,0'), ('goals', '0,inf')])
def test_bounds_that_mean_nothing_are_refused(by, words):
    with pytest.raises(Trouble):
        checked_bounds(by, words)
