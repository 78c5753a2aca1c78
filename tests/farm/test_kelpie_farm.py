# SPDX-License-Identifier: Apache-2.0
# What the program kelpie has to do with the farm: it becomes it, and plays single matches for it.
import json
import os
import subprocess
from pathlib import Path

import pytest
from farm_field import ROOT

KELPIE = Path(os.environ.get('KELPIE_BIN', ROOT / 'build/host/bin')) / 'kelpie'
TEAMS = ('teams/kelpie', 'teams/thesis')
needs_kelpie = pytest.mark.skipif(not KELPIE.is_file(), reason='kelpie is not built here')
pytestmark = needs_kelpie


def kelpie(*words, **options):
    return subprocess.run([KELPIE, *map(str, words)], capture_output=True, text=True, check=False,
                          timeout=240, **{'cwd': ROOT, **options})


def test_kelpie_farm_becomes_the_farm_with_its_help_and_its_exit_codes():
    assert 'worker' in kelpie('farm', '--help').stdout
    refused = kelpie('farm', 'status', '--out', 'nowhere')
    assert refused.returncode == 2
    assert refused.stderr == 'kelpie: nowhere/farm.sqlite: no such file\n'


def test_a_league_until_decided_is_played_by_the_farm(field):
    pytest.importorskip('distributed', reason='no Dask: tools/install farm')
    words = ['strong', 'weak', '--by', 'goals', '--bounds', '0,0.8', '--minutes', '3', '--seed',
             '4', '--robots', '2v2', '--workers', '2', '--out', 'out']
    result = kelpie('league', *words, '--until', 'decided', cwd=field.folder,
                    env=field.environment())
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith('accepted after ')
    assert ('strong against weak, 3 min, 2v2, from images: is the mean goals of strong 0 or 0.8?'
            in result.stderr)
    assert field.matches_played()[0].split()[0] in ('4', '5')
    assert (field.folder / 'out/farm.sqlite').is_file()


def test_scenes_are_played_in_turn_until_one_side_is_known_to_be_better(field):
    pytest.importorskip('distributed', reason='no Dask: tools/install farm')
    words = ['strong', 'weak', '--by', 'goals', '--bounds', '0,0.8', '--out', 'out']
    result = field.farm('play', *words, '--scenes', 'all')
    assert result.returncode == 0, result.stderr
    assert 'weak, scenes (edge, scrum), no images: is the mean goals' in result.stderr
    refused = field.farm('play', *words, '--scenes', 'edge,party')
    assert refused.returncode == 2
    assert refused.stderr == 'kelpie: --scenes party: there are edge, scrum\n'
    refused = field.farm('play', *words, '--scenes', ',')
    assert refused.returncode == 2
    assert refused.stderr == 'kelpie: --scenes ,: all, or some of edge, scrum\n'


@pytest.mark.parametrize('words, complaint', [
    (['--until', 'tired'], '--until'), (['--until', 'decided', '--matches', '4'], '--matches'),
    (['--by', 'goals'], '--until'), (['--once', '--until', 'decided'], '--until'),
    (['--once', '--robots', '9v9'], '9v9'),
    (['teams/README.md', '--once'], 'teams/README.md')])
def test_words_that_do_not_go_together_are_refused(words, complaint):
    result = kelpie('league', *TEAMS, *words)
    assert result.returncode == 2 and result.stdout == ''
    assert complaint in result.stderr


def test_one_match_has_two_teams():
    result = kelpie('league', 'teams/kelpie', 'teams/thesis', 'teams', '--once')
    assert result.returncode == 2 and 'one match has two teams' in result.stderr


def test_what_a_match_depends_on_is_the_same_for_both_colours():
    one = kelpie('league', *TEAMS, '--about')
    other = kelpie('league', *TEAMS[::-1], '--about')
    assert one.returncode == 0 and one.stdout == other.stdout
    about = json.loads(one.stdout)['about']
    for part in ('commit ', 'field lists ', '4v4', ', kelpie ', ', thesis '):
        assert part in about


def test_one_match_is_played_as_the_league_plays_it(tmp_path):
    words = (*TEAMS, '--robots', '1v1', '--minutes', '0.1', '--seed', '3')
    once = kelpie('league', *words[1::-1], *words[2:], '--once')
    assert once.returncode == 0, once.stderr
    result = json.loads(once.stdout)
    assert (result['red'], result['blue'], result['seed']) == ('thesis', 'kelpie', 3)
    league = kelpie('league', *words, '--matches', '2', '--out', tmp_path / 'league')
    assert league.returncode == 0, league.stderr
    second = json.loads((tmp_path / 'league/league.jsonl').read_text().splitlines()[2])
    for key in ('red', 'blue', 'red_goals', 'blue_goals', 'outs', 'seconds'):
        assert result[key] == second[key]
