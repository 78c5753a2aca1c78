# SPDX-License-Identifier: Apache-2.0
# What people read of a test: question, running line, decision, trouble and speed.
import pytest
from farm import words
from farm.plan import Judged, Plan

PLAN = Plan('teams/kelpie', 'teams/thesis', 1, 2.0, '4v4', 'images', 'goals', 0.0, 0.25)


def played(pairs, plan=PLAN):
    """Pairs of (goals, others' goals) as the first side sees them, the same in both matches."""
    results = {}
    for seed, (own, others) in enumerate(pairs, plan.seed):
        results[seed, 'red'] = {'trouble': '', 'red_goals': own, 'blue_goals': others,
                                'machine': 'one:7'}
        results[seed, 'blue'] = {'trouble': '', 'red_goals': others, 'blue_goals': own,
                                 'machine': 'two:8'}
    judged = Judged(plan)
    judged.take(results)
    return judged, results


def test_the_question_names_teams_match_and_both_means():
    assert words.question(PLAN) == (
        'kelpie against thesis, 2 min, 4v4, from images: is the mean goals of kelpie 0 or 0.25?')
    assert ', bodies with masses: is' in words.question(PLAN._replace(world='physical'))
    assert 'thesis, scenes (edge, scrum), no images: is' in words.question(
        PLAN._replace(world='percepts', scenes=('edge', 'scrum')))


def test_the_running_line_has_goals_estimate_ratio_and_what_is_to_go():
    judged, _ = played([(2, 1), (1, 1)])
    # mean 0.5, variance 0.5: LLR 2 x 0.25 x (1 - 0.25) / (2 x 0.5) = 0.375
    line = words.running(judged)
    assert line.startswith('pair 2: kelpie 6 : 4 thesis; goals +0.50 (')
    assert '; LLR +0.38 of +-2.94; about ' in line and line.endswith(' matches to go')


def test_of_one_pair_the_interval_and_the_way_to_go_are_unknown():
    line = words.running(played([(2, 1)])[0])
    assert 'goals +1.00 (? .. ?)' in line and 'nobody knows how many matches to go' in line


def test_scores_are_between_0_and_1_whatever_the_interval_says():
    judged, _ = played([(2, 1), (1, 2)], PLAN._replace(by='score', low=0.5, high=0.6))
    assert words.estimate(judged) == '0.500 (0.000 .. 1.000)'


@pytest.mark.parametrize('pairs, said', [
    ([(2, 0), (1, 0)] * 8, 'accepted after 16 pairs, 32 matches: the mean goals of kelpie is 0.25 '
                           'rather than 0; LLR '),
    ([(0, 2), (0, 1)] * 8, 'rejected after 16 pairs, 32 matches: the mean goals of kelpie is 0 '
                           'rather than 0.25; LLR '),
    ([(1, 0), (0, 1)], 'undecided after 2 pairs')])
def test_the_decision_says_which_mean_it_is(pairs, said):
    assert words.decision(played(pairs)[0]).startswith(said)


def test_troubles_are_told_once_each_with_how_often_they_came():
    results = {1: {'trouble': 'stuck'}, 2: {'trouble': ''}, 3: {'trouble': 'dead'},
               4: {'trouble': 'stuck'}}
    assert words.voids(results) == ['void: dead (1 x)', 'void: stuck (2 x)']


def test_speed_is_of_the_last_hour():
    assert words.speed([0.0, 9000.0, 9010.0, 9020.0], 9030.0) == '360 matches an hour'
    assert words.speed([0.0, 9000.0], 9030.0) == ''


def test_the_status_names_machines_and_how_many_matches_each_has_played():
    judged, results = played([(2, 0)] * 3)
    lines = words.status(judged, results, [], 0.0)
    assert lines[0] == f'test {PLAN.id}: {words.question(PLAN)}'
    assert '  6 matches: one 3, two 3' in lines
