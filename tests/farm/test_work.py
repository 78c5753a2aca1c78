# SPDX-License-Identifier: Apache-2.0
# One match: played by this machine's kelpie, and whatever goes wrong is a trouble of one line.
import os
import subprocess
import sys
import time

import pytest
from farm import work
from farm.work import Match, Trouble, about, play, portable, words_of
from farm_field import FAKE, ROOT


@pytest.fixture(name='match')
def a_match(field, monkeypatch):
    monkeypatch.setenv('KELPIE_PROGRAM', str(FAKE))
    monkeypatch.setenv('FAKE_PLAYED', str(field.played))
    return Match(str(field.folder / 'strong'), str(field.folder / 'weak'), 7, 2.0, '4v4',
                 'images', 'fake 1 strong weak')


def program(folder, text):
    path = folder / 'program'
    path.write_text('#!/bin/sh\n' + text)
    path.chmod(0o755)
    return str(path)


def test_a_match_has_a_result_and_says_where_it_was_played(match, field):
    result = play(match)
    assert result['trouble'] == '' and result['red_goals'] >= 0
    assert result['machine'].endswith(f':{os.getpid()}') and 0.0 < result['took'] < 60.0
    assert field.matches_played() == ['7 strong']


def test_the_same_match_has_the_same_result(match):
    first, second = play(match), play(match)
    assert [first[k] for k in ('red_goals', 'blue_goals')] == [
        second[k] for k in ('red_goals', 'blue_goals')]


def test_what_a_match_depends_on_does_not_depend_on_the_colours(match):
    assert about(match) == about(match._replace(red=match.blue, blue=match.red)) == (
        match.about, ['edge', 'scrum'])


@pytest.mark.parametrize('change, words', [
    ({}, ['--rules', '2006', '--minutes', '2.0', '--robots', '4v4']),
    ({'world': 'percepts', 'rules': '2005'},
     ['--percepts', '--rules', '2005', '--minutes', '2.0', '--robots', '4v4']),
    ({'world': 'physical', 'scene': 'edge'},
     ['--physical', '--rules', '2006', '--scene', 'edge'])])
def test_a_match_is_asked_for_in_its_world_and_a_scene_without_minutes(match, change, words):
    assert words_of(match._replace(**change))[3:] == ['--seed', '7', *words]


def test_a_machine_with_another_version_is_found_out(match, monkeypatch):
    monkeypatch.setenv('FAKE_VERSION', '2')
    assert play(match)['trouble'] == 'another version plays here: fake 2 strong weak'


@pytest.mark.parametrize('text, trouble', [
    ('exit 3', 'kelpie failed with 3: nothing'),
    ('echo one >&2; echo "the world died" >&2; exit 3', 'kelpie failed with 3: the world died'),
    ('echo no json', 'kelpie printed no result'),
    ('echo "[1]"', 'kelpie printed no result'),
    ("""echo '{"about": "fake 1 strong weak"}'""", 'a result without red_goals'),
    ("""echo '{"about": "fake 1 strong weak", "red_goals": 1, "blue_goals": -1}'""",
     'a result without blue_goals'),
    ("""echo '{"about": "fake 1 strong weak", "red_goals": 1, "blue_goals": 1, "value": NaN}'""",
     'a value that is not finite'),
    ("""echo '{"about": "fake 1 strong weak", "trouble": "stuck"}'""", 'stuck'),
    ('kill -9 $$', 'kelpie failed with -9: nothing')])
def test_what_goes_wrong_is_one_line(match, monkeypatch, tmp_path, text, trouble):
    monkeypatch.setenv('KELPIE_PROGRAM', program(tmp_path, text))
    assert play(match)['trouble'] == trouble


def test_a_match_that_is_never_over_is_ended(match, monkeypatch, tmp_path):
    monkeypatch.setenv('KELPIE_PROGRAM', program(tmp_path, 'exec sleep 100'))
    monkeypatch.setattr(work, 'START', 0.3)
    monkeypatch.setattr(work, 'PATIENCE', 0.0)
    begun = time.monotonic()
    assert play(match)['trouble'] == 'not over after 0 s'
    assert time.monotonic() - begun < 30.0


def test_a_program_that_is_not_there_is_one_line(match, monkeypatch):
    monkeypatch.setenv('KELPIE_PROGRAM', '/nowhere/kelpie')
    assert play(match)['trouble'].startswith('kelpie failed with ')
    with pytest.raises(Trouble):
        about(match)


def test_a_match_ends_with_the_worker_that_plays_it(match, tmp_path):
    pid = tmp_path / 'pid'
    environment = {**os.environ, 'PYTHONPATH': str(ROOT / 'tools'),
                   'KELPIE_PROGRAM': program(tmp_path, f'echo $$ > {pid}; exec sleep 100')}
    worker = subprocess.Popen(
        [sys.executable, '-c', f'from farm.work import play; play({tuple(match)!r})'],
        env=environment)
    until = time.monotonic() + 30.0
    while not (pid.is_file() and pid.read_text()) and time.monotonic() < until:
        time.sleep(0.02)
    worker.kill()
    worker.wait()
    while os.path.exists(f'/proc/{int(pid.read_text())}/exe') and time.monotonic() < until:
        time.sleep(0.02)
    assert time.monotonic() < until


def test_a_team_of_the_source_tree_is_where_each_machine_has_its_own():
    assert portable(ROOT / 'teams/kelpie') == 'teams/kelpie'
    assert portable('/elsewhere/team') == '/elsewhere/team'
