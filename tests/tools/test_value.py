# SPDX-License-Identifier: Apache-2.0
# learn.py of the value of play on small made sets, and kelpie value on files that are none.
import json
import random
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import complaint, kelpie

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / 'tools/league/value'
sys.path.insert(0, str(FOLDER))

learn = pytest.importorskip('learn')
sklearn = pytest.importorskip('sklearn')

NAMES = list(learn.PLACES)


def made(path, matches=10, moments=300, goals=True):
    """Rows in which a ball near the goal scores in half of all cases and one far away never."""
    draw = random.Random(7)
    lines = [','.join(['match', 'seconds', 'team', 'left', 'ends', *NAMES])]
    for match in range(matches):
        for moment in range(moments):
            near = draw.random() < 0.2
            scores = goals and near and draw.random() < 0.5
            goal = draw.uniform(0, 60) if near else draw.uniform(150, 400)
            cells = [goal if name in ('goal', 'restGoal') else 0.0 for name in NAMES]
            lines.append(','.join(map(str, [f'm{match}', moment, 'red', 5.0 if scores else 99.0,
                                            int(scores), *cells])))
    path.write_text('\n'.join(lines) + '\n')
    return path


def run(*words):
    return subprocess.run([sys.executable, str(FOLDER / 'learn.py'), *map(str, words)],
                          capture_output=True, text=True, check=False)


@pytest.fixture(scope='module')
def learnt(tmp_path_factory):
    folder = tmp_path_factory.mktemp('value')
    done = run(made(folder / 'rows.csv'), '--out', folder / 'model.json',
               '--plot', folder / 'plot.svg')
    assert done.returncode == 0, done.stderr
    return folder, json.loads(done.stdout)


def probability(model, features):
    odds = model['base']
    for curve in model['curves']:
        odds += float(learn.np.interp(features[curve['feature']], curve['at'], curve['adds']))
    return 1.0 / (1.0 + float(learn.np.exp(-odds)))


def at(goal):
    return {name: goal if name in ('goal', 'restGoal') else 0.0 for name in NAMES}


def test_finds_where_goals_come_from(learnt):
    model = json.loads((learnt[0] / 'model.json').read_text())
    assert probability(model, at(30.0)) == pytest.approx(0.5, abs=0.12)
    assert probability(model, at(300.0)) < 0.05


def test_is_better_than_the_base_rate_on_matches_that_it_has_not_seen(learnt):
    figures = learnt[1]
    assert figures['gain'] > 0.3
    assert figures['calibration_error'] < 0.03
    assert figures['matches'] == 10


def test_the_model_says_what_it_was_learnt_from(learnt):
    learned = json.loads((learnt[0] / 'model.json').read_text())['learnt']
    assert learned['from'] == [f'm{i}' for i in range(10)]


def test_the_plot_is_a_picture_with_a_dot_a_bin(learnt):
    picture = (learnt[0] / 'plot.svg').read_text()
    assert picture.startswith('<svg') and picture.count('<circle') == learn.BINS


def test_kelpie_reads_the_model_that_was_learnt(learnt):
    folder = learnt[0]
    for name in ('near.json', 'far.json'):
        (folder / name).write_text((folder / 'model.json').read_text())
    log = folder / 'none.mcap'
    log.write_text('no log')
    said = kelpie('value', log, '--models', folder)
    assert said.returncode == 2 and 'none.mcap' in complaint(said)


@pytest.mark.parametrize('text', ['', 'a,b\n1,2\n', 'match,team,left,ends\nm,red,x,1\n', '\0\xff'])
def test_a_file_that_holds_no_rows_gives_one_line(tmp_path, text):
    rows = tmp_path / 'rows.csv'
    rows.write_text(text)
    done = run(rows, '--out', tmp_path / 'model.json')
    assert done.returncode == 2
    assert done.stderr.startswith('learn.py: ') and done.stderr.count('\n') == 1
    assert not (tmp_path / 'model.json').exists()


def test_rows_without_a_goal_teach_nothing(tmp_path):
    done = run(made(tmp_path / 'rows.csv', moments=20, goals=False), '--out', tmp_path / 'm.json')
    assert done.returncode == 2 and 'too little to learn from' in done.stderr


def test_a_moment_whose_stretch_ends_before_the_horizon_by_no_goal_is_left_out():
    columns = {'left': learn.np.array([5.0, 5.0, 5.0, 50.0]),
               'ends': learn.np.array([0.0, 1.0, -1.0, 1.0])}
    hit, known = learn.scored(columns, 10.0)
    assert list(known) == [False, True, True, True]
    assert list(hit[known]) == [1, 0, 0]


def test_a_folder_without_models_gives_one_line(tmp_path):
    log = tmp_path / 'none.mcap'
    log.write_text('no log')
    said = kelpie('value', log, '--models', tmp_path)
    assert said.returncode == 2 and 'near.json' in complaint(said)


def test_a_log_without_truth_leaves_no_rows(tmp_path):
    log = tmp_path / 'none.mcap'
    log.write_text('no log')
    said = kelpie('value', log, '--rows', tmp_path / 'rows.csv')
    assert said.returncode == 2 and complaint(said)
    assert not (tmp_path / 'rows.csv').exists()


def test_a_match_of_its_own_tells_its_value_as_red_sees_it():
    played = kelpie('league', ROOT / 'teams/kelpie', ROOT / 'teams/thesis', '--once', '--percepts',
                    '--minutes', '0.1', '--seed', '3')
    assert played.returncode == 0, played.stderr
    told = json.loads(played.stdout)
    assert told['value'] == pytest.approx(told['red_value'] - told['blue_value'])
    for key in ('red_shots', 'red_xg', 'blue_shots', 'blue_xg'):
        assert told[key] >= 0


def test_play_tells_expected_goals_and_kelpie_value_the_same_of_its_log(tmp_path):
    played = kelpie('play', '--robots', '1v1', '--percepts', '--fast', '--minutes', '0.2',
                    '--out', tmp_path)
    assert played.returncode == 0, played.stderr
    line = next(line for line in played.stdout.splitlines() if line.startswith('expected goals '))
    said = kelpie('value', tmp_path / 'match.mcap')
    assert said.returncode == 0, said.stderr
    red = next(line for line in said.stdout.splitlines() if line.startswith('red '))
    assert line.split()[2] == red.split()[2]


def test_evaluate_judges_matches_of_both_teams(tmp_path):
    done = kelpie('evaluate', 'value', '--fast', '--trials', '1', '--minutes', '0.2', '--seed', '5',
                  '--json', tmp_path / 'figures.json')
    assert done.returncode == 0, done.stderr
    figures = json.loads((tmp_path / 'figures.json').read_text())
    assert 0.1 < figures['played_min'] < 0.6
    assert set(figures['near']) == set(figures['far'])
