# SPDX-License-Identifier: Apache-2.0
# A search as a command, with a fake kelpie whose teams are best with one constant at 110.
import json
import signal
import sqlite3
import time
import tomllib

import pytest

WORDS = ['search', '--pool', 'even', '--groups', 'dribble', '--by', 'goals', '--scenes', 'all',
         '--pairs', '8', '--out', 'out', '--workers', '2', '--seed', '20']


@pytest.fixture(name='pool')
def a_pool(field):
    pytest.importorskip('distributed', reason='no Dask: tools/install farm')
    pytest.importorskip('optuna', reason='no Optuna: tools/install farm')
    field.team('even', 2.0)
    return field


def carry_to(field):
    team = tomllib.loads((field.folder / 'out/champion/team.toml').read_text())
    return float(team['behaviour']['constants']['dribble']['carryTo'].removesuffix('cm'))


def test_a_planted_optimum_is_found_and_its_gain_is_told(pool):
    result = pool.farm(*WORDS, '--trials', '25')
    assert result.returncode == 0, result.stderr
    assert 'of a scene over the defaults, on fresh seeds' in result.stdout
    assert 90.0 < carry_to(pool) <= 130.0
    told = pool.farm('history', '--out', 'out').stdout
    assert 'out/champion: +' in told and 'tpe over 5 constants, 25 vectors, 8 pairs' in told


def test_a_search_that_was_killed_goes_on_with_what_it_has_played(pool):
    whole = pool.farm(*WORDS, '--trials', '6')
    played = len(pool.matches_played())
    first = (pool.folder / 'out/champion/team.toml').read_text()
    pool.played.write_text('')
    started = pool.start(*[word if word != 'out' else 'again' for word in WORDS], '--trials', '6')
    while len(pool.matches_played()) < played // 2:
        time.sleep(0.05)
    started.send_signal(signal.SIGKILL)
    started.wait()
    again = pool.farm(*[word if word != 'out' else 'again' for word in WORDS], '--trials', '6')
    assert again.stdout.splitlines()[0] == whole.stdout.splitlines()[0]
    assert (pool.folder / 'again/champion/team.toml').read_text() == first
    in_flight = 12
    assert len(pool.matches_played()) <= played + in_flight


def test_each_vector_has_seeds_of_its_own_and_meets_the_whole_pool(pool):
    pool.team('weak', 0.5)
    words = ['even,weak' if word == 'even' else word for word in WORDS]
    assert pool.farm(*words, '--trials', '3', '--sampler', 'climb').returncode == 0
    base = sqlite3.connect(pool.folder / 'out/farm.sqlite')
    plans = [json.loads(plan) for plan, in base.execute('select plan from tests')]
    tried = [(plan['seed'], plan['second']) for plan in plans if plan['seed'] < 1000]
    assert {seed for seed, _ in tried} == {20, 28, 36}
    assert len(tried) == 6 and {second.split('/')[-1] for _, second in tried} == {'even', 'weak'}


@pytest.mark.parametrize('words, complaint', [
    (['--pool', 'even,nobody'], 'nobody: no such folder'),
    (['--groups', 'party'], '--groups party: there are grab'),
    (['--scenes', 'party'], '--scenes party: there are edge, scrum'),
    (['--trials', '0'], '--trials: 0: from 1 to 100000')])
def test_what_cannot_be_searched_is_refused_in_a_line(pool, words, complaint):
    result = pool.farm(*WORDS, *words)
    assert result.returncode == 2 and result.stdout == ''
    assert complaint in result.stderr and len(result.stderr.splitlines()) == 1
