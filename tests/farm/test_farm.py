# SPDX-License-Identifier: Apache-2.0
# kelpie farm as a user has it: a test on this machine's own workers and on a scheduler's, what it
# says, and one line when something is wrong.
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from farm.children import free_port
from farm_field import MAIN


@pytest.fixture(name='dask')
def needs_dask():
    pytest.importorskip('distributed', reason='no Dask: tools/install farm')


def one_line(result):
    assert result.returncode == 2 and result.stdout == '', result
    assert result.stderr.startswith('kelpie: ') and result.stderr.count('\n') == 1, result.stderr
    return result.stderr


@pytest.mark.parametrize('words, complaint', [
    ([], 'required: COMMAND'),
    (['dance'], 'invalid choice'),
    (['play', 'strong'], 'required: team'),
    (['play', 'strong', 'nobody'], 'nobody: no such folder'),
    (['play', 'strong', 'strong'], "both teams are called 'strong'"),
    (['play', 'strong', 'weak', '--bounds', '1,0'], 'LOW is below HIGH'),
    (['play', 'strong', 'weak', '--by', 'value', '--bounds', '1'], 'two numbers'),
    (['play', 'strong', 'weak', '--seed', '-1'], '-1: from 0'),
    (['play', 'strong', 'weak', '--minutes', 'nan'], 'nan: from 0.1'),
    (['play', 'strong', 'weak', '--workers', 'two'], 'two'),
    (['play', 'strong', 'weak', '--out', 'strong/strength'], 'strong/strength'),
    (['play', 'strong', 'weak', '--scheduler', 'here'], 'here: tcp://HOST:PORT'),
    (['status', '--out', 'nowhere'], 'no such file'),
    (['worker', 'here'], 'here: tcp://HOST:PORT'),
])
def test_a_mistake_is_told_in_one_line(field, words, complaint):
    assert complaint in one_line(field.farm(*words))


def test_without_dask_the_farm_says_how_to_get_it(field):
    (field.folder / 'distributed.py').write_text('raise ImportError("not here")')
    result = field.farm('play', 'strong', 'weak', PYTHONPATH=str(field.folder))
    assert one_line(result) == 'kelpie: the farm needs Dask: tools/install farm\n'


def test_the_better_team_is_found_and_the_test_is_told(field, dask):
    result = field.farm('play', 'strong', 'weak', '--by', 'goals', '--bounds', '0,0.8', '--out',
                        'out')
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith('accepted after ')
    assert 'the mean goals of strong is 0.8 rather than 0' in result.stdout
    running = result.stderr.splitlines()[-1]
    for part in ('LLR ', 'of +-2.94', ' .. ', 'matches to go', ' weak; goals +'):
        assert part in running
    told = field.farm('status', '--out', 'out').stdout
    assert 'no farm plays now' in told and result.stdout.strip() in told
    assert 'is the mean goals of strong 0 or 0.8?' in told and 'matches an hour' in told


def test_the_worse_team_is_rejected_and_the_same_command_plays_nothing_more(field, dask):
    words = ('play', 'weak', 'strong', '--bounds', '0.45,0.55', '--out', 'out')
    result = field.farm(*words)
    assert result.returncode == 0 and result.stdout.startswith('rejected after ')
    played = field.matches_played()
    again = field.farm(*words)
    assert again.stdout == result.stdout and field.matches_played() == played


def test_where_every_match_fails_the_farm_gives_up_in_one_line_and_leaves_no_process(field, dask):
    result = field.farm('play', 'strong', 'weak', '--out', 'out', FAKE_TROUBLE='the world died')
    assert result.returncode == 2 and result.stdout == ''
    assert result.stderr.splitlines()[-1] == (
        'kelpie: 8 matches in a row failed: kelpie failed with 1: the world died')
    assert str(field.folder) not in commands_that_run()


def commands_that_run():
    return subprocess.run(['ps', '-eo', 'args'], capture_output=True, text=True, check=True).stdout


def wait_until(true, seconds=100.0):
    until = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < until
        time.sleep(0.05)


def test_a_farm_that_is_interrupted_says_how_to_go_on_and_does(field, dask):
    words = ('play', 'strong', 'weak', '--out', 'out')
    farm = field.start(*words, FAKE_SECONDS='0.3')
    wait_until(lambda: len(field.matches_played()) > 3)
    farm.send_signal(signal.SIGINT)
    said = farm.communicate(timeout=60)[0]
    assert farm.returncode == 130 and 'kelpie: stopped; the same command goes on' in said
    assert 'Traceback' not in said
    assert field.farm(*words).returncode == 0
    matches = field.matches_played()
    assert len(matches) - len(set(matches)) <= 3     # those under way at the interrupt


@pytest.fixture(name='network')
def other_machines(field, dask):
    """The address of a scheduler with two workers, each a process as of another machine."""
    address = f'tcp://127.0.0.1:{free_port()}'
    words = [['scheduler', '--port', address.rsplit(':', 1)[1], '--out', 'scheduler'],
             ['worker', address, '--workers', '1', '--host', '127.0.0.1', '--out', 'one'],
             ['worker', address, '--workers', '1', '--host', '127.0.0.1', '--out', 'two']]
    started = [subprocess.Popen([sys.executable, MAIN, *word], cwd=field.folder,
                                env=field.environment()) for word in words]
    yield address
    for process in started:
        process.send_signal(signal.SIGINT)
    assert [process.wait(timeout=30) for process in started] == [0, 0, 0]


def listening(pid):
    """Addresses at which a process and its children listen."""
    children = subprocess.run(['ps', '-o', 'pid=', '--ppid', str(pid)], capture_output=True,
                              text=True, check=True).stdout.split()
    links = [link for one in (pid, *children) for link in Path(f'/proc/{one}/fd').glob('*')]
    sockets = {os.readlink(link) for link in links if os.path.islink(link)}
    for table in ('/proc/net/tcp', '/proc/net/tcp6'):
        for line in Path(table).read_text().splitlines()[1:]:
            words = line.split()
            if words[3] == '0A' and f'socket:[{words[9]}]' in sockets:
                yield words[1].split(':')[0]


def test_a_farm_of_one_machine_listens_to_that_machine_alone(field, dask):
    farm = field.start('play', 'strong', 'weak', '--out', 'out', '--workers', '1',
                       FAKE_SECONDS='0.3')
    wait_until(lambda: len(field.matches_played()) > 1)
    addresses = list(listening(farm.pid))
    farm.send_signal(signal.SIGINT)
    farm.communicate(timeout=60)
    assert len(addresses) >= 2      # scheduler and worker
    assert set(addresses) == {'0100007F'}     # 127.0.0.1


def test_workers_of_other_machines_play_for_whoever_asks_their_scheduler(field, network):
    result = field.farm('play', 'strong', 'weak', '--scheduler', network, '--out', 'out', '--by',
                        'goals', '--bounds', '0,0.8')
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith('accepted after ')
    own = field.farm('play', 'strong', 'weak', '--out', 'own', '--by', 'goals', '--bounds', '0,0.8')
    assert own.stdout == result.stdout
    assert not os.path.exists(field.folder / 'out/cluster.log')     # it started nobody
