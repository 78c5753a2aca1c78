# SPDX-License-Identifier: Apache-2.0
"""One match as plain data, and the function that plays it: on any machine, with that machine's own
`kelpie`, once more with the same result. It keeps nothing. What goes wrong is the result's
`trouble`, in one line: a match that takes too long, a program that dies, an answer that is none, or
that of another version of Kelpie or of a team than the test is of."""

import json
import math
import os
import socket
import subprocess
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = 'KELPIE_PROGRAM'   # environment: this machine's kelpie
PATIENCE = 30.0              # s of waiting for each s of play
START = 300.0                # s of waiting besides
LONGEST = 300                # characters of a trouble
PERCEPTS, IMAGES, PHYSICAL = 'percepts', 'images', 'physical'
WORLDS = {PERCEPTS: ['--percepts'], IMAGES: [], PHYSICAL: ['--physical']}


class Match(NamedTuple):
    """`red` and `blue` are folders of teams; one of the source tree is relative to it, so that each
    machine takes its own. `world`: PERCEPTS, IMAGES or PHYSICAL. `about` is what Kelpie says of all
    that the result depends on. `scene`: a kind of situation that is played in place of a match of
    these minutes and robots; empty: none. `rules`: of which year."""
    red: str
    blue: str
    seed: int
    minutes: float
    robots: str
    world: str
    about: str
    scene: str = ''
    rules: str = '2006'


class Trouble(Exception):
    """Why something cannot be done, in one line."""


def program():
    return os.environ.get(PROGRAM, str(ROOT / 'build/host/bin/kelpie'))


def one_line(text):
    words = ' '.join(str(text).split())
    return words[:LONGEST] or 'unknown'


def portable(folder):
    """A team's folder as another machine finds it; with links left as they are, since a team's name
    is its folder's."""
    path = Path(os.path.abspath(folder))
    return str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)


def words_of(match):
    folders = [str(ROOT / folder) for folder in (match.red, match.blue)]
    words = ['league', *folders, '--seed', str(match.seed), *WORLDS[match.world],
             '--rules', match.rules]
    if match.scene:
        return [*words, '--scene', match.scene]
    return [*words, '--minutes', repr(match.minutes), '--robots', match.robots]


def asked(words, seconds):
    """The JSON object that kelpie prints. A match ends with the process that asked for it, however
    that one ends: setpriv has the kernel see to it, and kelpie does so for its own processes."""
    command = ['setpriv', '--pdeathsig', 'KILL', program(), *words]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors='replace',
                              check=False, stdin=subprocess.DEVNULL, timeout=seconds)
    except subprocess.TimeoutExpired:
        raise Trouble(f'not over after {seconds:.0f} s') from None
    except OSError as error:
        raise Trouble(error) from None
    if done.returncode != 0:
        said = (done.stderr.strip().splitlines() or ['nothing'])[-1].removeprefix('kelpie: ')
        raise Trouble(f'kelpie failed with {done.returncode}: {said}')
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        answer = None
    if not isinstance(answer, dict):
        raise Trouble('kelpie printed no result')
    return answer


def about(match):
    """What the match's result depends on here: version, robots, and both teams' contents; and the
    kinds of scenes that there are."""
    answer = asked([*words_of(match._replace(scene='')), '--about'], START)
    if not isinstance(answer.get('about'), str):
        raise Trouble('kelpie says nothing of its version')
    return answer['about'], answer.get('scenes', [])


def checked(answer, match):
    if answer.get('about') != match.about:
        raise Trouble(f"another version plays here: {answer.get('about')}")
    if answer.get('trouble'):
        raise Trouble(answer['trouble'])
    for key in ('red_goals', 'blue_goals'):
        if not is_goals(answer.get(key)):
            raise Trouble(f'a result without {key}')
    if 'value' in answer and not is_figure(answer['value']):
        raise Trouble('a value that is not finite')
    return {key: value for key, value in answer.items() if key != 'about'}


def is_goals(value):
    return type(value) is int and value >= 0


def is_figure(value):
    return type(value) in (int, float) and math.isfinite(value)


def play(match):
    """{'trouble': one line or '', 'machine': whose, 'took': s, figures of the match}. Runs on a
    worker; `match` is what a Match holds."""
    match = Match(*match)
    begun = time.monotonic()
    try:
        result = checked(asked([*words_of(match), '--once'],
                               START + 60.0 * match.minutes * PATIENCE), match)
        result['trouble'] = ''
    except Trouble as trouble:
        result = {'trouble': one_line(trouble)}
    return {**result, 'machine': f'{socket.gethostname()}:{os.getpid()}',
            'took': round(time.monotonic() - begun, 3)}
