#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""sample.py --out FOLDER   plays matches of percepts and keeps rows of them, to learn from.

Seed by seed teams/kelpie, teams/thesis and teams/runner meet in the pairings below. A match is a
file of rows (`kelpie value --rows`, 170 kB); what is there already is not played again, so that the
same command goes on where it was stopped. One match at a time: the same command with other seeds
beside it."""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
KELPIE = os.environ.get('KELPIE_PROGRAM', str(ROOT / 'build/host/bin/kelpie'))
PAIRINGS = [('kelpie', 'thesis'), ('runner', 'kelpie'), ('thesis', 'kelpie'), ('kelpie', 'runner'),
            ('kelpie', 'kelpie'), ('runner', 'thesis'), ('runner', 'runner'), ('thesis', 'runner')]


def play(seed, red, blue, minutes, rows):
    """Error: what kelpie said last."""
    with tempfile.TemporaryDirectory() as folder:
        log, part = f'{folder}/match.mcap', f'{folder}/{seed}-{red}-{blue}.mcap'
        commands = [
            [KELPIE, 'play', '--robots', '4v4', '--percepts', '--fast', '--seed', str(seed),
             '--minutes', str(minutes), '--red', str(ROOT / 'teams' / red),
             '--blue', str(ROOT / 'teams' / blue), '--out', folder],
            ['mv', log, part],
            [KELPIE, 'value', part, '--rows', str(rows)]]
        for command in commands:
            done = subprocess.run(command, capture_output=True, text=True, errors='replace',
                                  check=False, stdin=subprocess.DEVNULL)
            if done.returncode != 0:
                said = done.stderr.strip().splitlines() or ['nothing']
                return f'seed {seed}: {said[-1]}'
    return ''


def options_from(words):
    parser = argparse.ArgumentParser(prog='sample.py', description=__doc__.splitlines()[0])
    parser.add_argument('--out', required=True, help='folder of the rows')
    parser.add_argument('--seed', type=int, default=100000, help='the first (%(default)s)')
    parser.add_argument('--matches', type=int, default=200, help='how many seeds (%(default)s)')
    parser.add_argument('--minutes', type=float, default=5.0, help='of play each (%(default)s)')
    options = parser.parse_args(words)
    if options.seed < 0 or options.matches < 1 or not 0.1 <= options.minutes <= 60.0:
        parser.error('a seed from 0 on, a match at least, and 0.1 to 60 minutes')
    return options


def main(words):
    options = options_from(words)
    out = Path(options.out)
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        print(f'sample.py: {error}', file=sys.stderr)
        return 2
    for seed in range(options.seed, options.seed + options.matches):
        red, blue = PAIRINGS[seed % len(PAIRINGS)]
        rows = out / f'{seed}-{red}-{blue}.csv'
        trouble = '' if rows.exists() else play(seed, red, blue, options.minutes, rows)
        if trouble:
            print(f'sample.py: {trouble}', file=sys.stderr)
            return 3
    return 0


if __name__ == '__main__':
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
