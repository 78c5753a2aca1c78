# SPDX-License-Identifier: Apache-2.0
# A farm of which scheduler, worker or the farm itself is killed twenty times, at random: nothing is
# counted twice, and nothing is lost but the matches under way.
import os
import random
import signal
import time
from pathlib import Path

import pytest
from farm.store import Store
from farm.work import Trouble

pytest.importorskip('distributed', reason='no Dask: tools/install farm')

KILLS = 20
ENDLESS = 100000     # pairs
WORKERS = 2
UNDER_WAY = 3       # matches handed out at a time to two workers
# Never decided: the two means are next to each other.
WORDS = ('play', 'strong', 'even', '--workers', str(WORKERS), '--bounds', '0.4999,0.5001')


def children_of(pid):
    """{pid: command line}"""
    found = {}
    for line in Path('/proc').glob('[0-9]*/stat'):
        try:
            parent = int(line.read_text().rsplit(')', 1)[1].split()[1])
            if parent == pid:
                found[int(line.parent.name)] = (line.parent / 'cmdline').read_text()
        except (OSError, IndexError):   # has ended meanwhile
            pass
    return found


class KilledFarm:
    """The same command, started again whenever it was killed."""

    def __init__(self, field, seed):
        self.field = field
        self.draw = random.Random(seed)
        self.process = None
        self.kills = {'scheduler': 0, 'worker': 0, 'farm': 0}

    def start(self):
        self.process = self.field.start(*WORDS, '--most', str(ENDLESS), '--out', 'out',
                                        FAKE_SECONDS='0.1')

    def results(self):
        try:
            store = Store(self.field.folder / 'out/farm.sqlite')
        except Trouble:     # it has not begun yet
            return {}
        found = [store.results(test) for test, _, _ in store.tests()]
        store.close()
        return found[0] if found else {}

    def play_on(self):
        """Until another match is in the store, and a moment longer."""
        before, until = len(self.results()), time.monotonic() + 150.0
        while len(self.results()) == before:
            assert time.monotonic() < until, 'it plays no more'
            assert self.process.poll() is None, self.process.stdout.read()
            time.sleep(0.02)
        time.sleep(self.draw.uniform(0.0, 0.2))

    def kill_one(self):
        whom = self.draw.choice(sorted(self.kills))
        if whom == 'farm':
            self.process.kill()
            self.process.wait()
            self.start()
        else:
            children = children_of(self.process.pid)
            pids = [pid for pid, words in children.items() if f'dask_{whom}' in words]
            if not pids:                # is just being started again
                return
            kill(self.draw.choice(sorted(pids)))
        self.kills[whom] += 1

    def killed(self):
        return sum(self.kills.values())


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def figures(results):
    return {key: (result['red_goals'], result['blue_goals']) for key, result in results.items()}


def test_twenty_kills_cost_the_matches_under_way_and_nothing_else(field):
    field.team('even', 2.0)
    farm = KilledFarm(field, seed=1)
    farm.start()
    while farm.killed() < KILLS:
        farm.play_on()
        before = farm.results()
        farm.kill_one()
        after = farm.results()
        assert {key: after[key] for key in before} == before
    farm.process.send_signal(signal.SIGINT)
    assert farm.process.wait(timeout=120) == 130
    assert min(farm.kills.values()) > 0, farm.kills
    pairs = max(seed for seed, _ in farm.results())
    whole = field.farm(*WORDS, '--most', pairs, '--out', 'out')
    results = farm.results()
    assert len(results) == 2 * pairs and not any(r['trouble'] for r in results.values())
    played = len(field.matches_played())
    assert 2 * pairs <= played <= 2 * pairs + (KILLS + 1) * UNDER_WAY
    undisturbed = field.farm(*WORDS, '--most', pairs, '--out', 'other')
    assert whole.stdout == undisturbed.stdout
    assert whole.stdout.startswith(f'undecided after {pairs} pairs')
    store = Store(field.folder / 'other/farm.sqlite')
    assert figures(store.results(store.tests()[0][0])) == figures(results)
