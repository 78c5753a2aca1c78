# SPDX-License-Identifier: Apache-2.0
"""What the farm remembers: one SQLite file with tests and the results of their matches. A match has
one row at most, by test, seed and the colour of the test's first side, so that nothing counts
twice, however often it was played. Each write is one transaction: a process that is killed loses
what it had not written, and nothing else. Only the farm's own process writes; whoever reads may do
so meanwhile. Not for a folder on a network, where SQLite's locks and its write-ahead log fail."""

import fcntl
import json
import sqlite3
import time
from pathlib import Path

from farm.work import Trouble, is_goals

RED, BLUE = 'red', 'blue'
SCHEMA = """
create table if not exists tests (
  id text primary key,
  plan text not null,          -- JSON: what is asked, and what the results depend on
  begun real not null) without rowid;
create table if not exists matches (
  test text not null,
  seed integer not null,
  colour text not null check (colour in ('red', 'blue')),   -- of the test's first side
  result text not null,        -- JSON, as work.play gives it
  void integer not null,       -- its result has trouble
  at real not null,            -- when it was written, s since 1970
  primary key (test, seed, colour)) without rowid;
create table if not exists champions (
  folder text not null,        -- of the team
  search text not null,        -- what was searched, in words
  vector text not null,        -- JSON: {parameter's key: number}
  gain real not null, low real not null, high real not null,   -- over the defaults, 95 % interval
  at real not null);
"""
VERSION = 2


class Store:
    """Refuses, in one line: a file that is no store, or of another version; with `writes` also one
    that another farm writes to."""

    def __init__(self, path, writes=False):
        self.path = Path(path)
        self.lock = None
        try:
            if writes:
                self.path.parent.mkdir(parents=True, exist_ok=True)
                self.lock = locked(self.path)
            elif not self.path.is_file():
                raise Trouble(f'{path}: no such file')
            self._open(writes)
        except (OSError, sqlite3.Error) as error:
            raise Trouble(f'{path}: {error}') from None

    def _open(self, writes):
        self.base = sqlite3.connect(self.path, timeout=30.0, isolation_level=None)
        version = self.base.execute('pragma user_version').fetchone()[0]
        tables = self.base.execute('select count(*) from sqlite_master').fetchone()[0]
        if not tables and not writes:
            raise Trouble(f'{self.path}: no test has begun yet')
        if version != VERSION and tables:
            raise Trouble(f"{self.path}: no store of the farm's, or of another version")
        if writes:
            self.base.execute('pragma journal_mode = wal')
            self.base.execute('pragma synchronous = full')
            self.base.executescript(f'begin; {SCHEMA} pragma user_version = {VERSION}; commit;')

    def close(self):
        self.base.close()
        if self.lock:
            self.lock.close()

    def begin(self, test, plan):
        self.base.execute('insert or ignore into tests values (?, ?, ?)',
                          (test, json.dumps(plan), time.time()))

    def add(self, test, seed, colour, result):
        """False: that match has its result already, which stays."""
        row = (test, seed, colour, json.dumps(result), int(bool(result['trouble'])), time.time())
        return self.base.execute('insert or ignore into matches values (?, ?, ?, ?, ?, ?)',
                                 row).rowcount == 1

    def forget_voids(self, test):
        """So that they are played again, when their cause has been mended."""
        self.base.execute('delete from matches where test = ? and void', (test,))

    def tests(self):
        """[(id, plan, begun)], oldest first."""
        rows = self.base.execute('select id, plan, begun from tests order by begun')
        return [(test, self._read(plan), begun) for test, plan, begun in rows]

    def results(self, test):
        """{(seed, colour): result}"""
        rows = self.base.execute('select seed, colour, result from matches where test = ?', (test,))
        return {(seed, colour): self._read(result, is_result) for seed, colour, result in rows}

    def _read(self, text, is_one=bool):
        """What a row holds as JSON; a damaged file is told in one line."""
        try:
            read = json.loads(text)
        except ValueError:
            read = None
        if not isinstance(read, dict) or not is_one(read):
            raise Trouble(f'{self.path}: damaged: a row says {text[:40]!r}')
        return read

    def add_champion(self, champion, search):
        row = (champion.folder, search, json.dumps(champion.vector), champion.gain, champion.low,
               champion.high, time.time())
        self.base.execute('insert into champions values (?, ?, ?, ?, ?, ?, ?)', row)

    def champions(self):
        """[(folder, search, vector, gain, low, high, at)], oldest first."""
        rows = self.base.execute('select * from champions order by at')
        return [(folder, search, json.loads(vector), *rest)
                for folder, search, vector, *rest in rows]

    def times(self, test):
        """When each match was written, in order; s since 1970."""
        rows = self.base.execute('select at from matches where test = ? order by at', (test,))
        return [at for at, in rows]


def is_result(read):
    goals = [read.get('red_goals'), read.get('blue_goals')]
    return isinstance(read.get('trouble'), str) and (
        read['trouble'] != '' or all(map(is_goals, goals)))


def lock_path(path):
    return Path(f'{path}.lock')


def locked(path):
    """An open file that is locked as long as it is open, and no longer than its process lives."""
    file = open(lock_path(path), 'w', encoding='ascii')
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise Trouble(f'{path}: another farm writes to it') from None
    return file


def is_locked(path):
    """Whether a farm writes there now."""
    if not lock_path(path).is_file():
        return False
    with open(lock_path(path), encoding='ascii') as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
    return False
