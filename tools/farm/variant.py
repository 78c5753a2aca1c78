# SPDX-License-Identifier: Apache-2.0
"""A team that plays as Kelpie but for some things: rules of pycode/lib/rulebook.py as the theses
have them, and switches of [behaviour.task]. So that what each of them gains can be played out. The
folder holds a copy of the behaviours when a rule is another one; only files of its own are
written."""

import ast
import json
import re
import shutil
import tomllib
from pathlib import Path

from farm.work import ROOT, Trouble

PYCODE = ROOT / 'pycode'
KELPIE = ROOT / 'teams/kelpie/team.toml'
RULES = 'lib/rulebook.py'
SETTING = re.compile(r'([A-Za-z]+)=(true|false|[0-9]+)')


def values(text):
    """{book: {rule: (line, value)}}, lines from 0, values as they are written."""
    books = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.ClassDef):
            books[node.name] = {
                one.targets[0].id: (one.lineno - 1, ast.get_source_segment(text, one.value))
                for one in node.body if isinstance(one, ast.Assign)}
    return books


def rulebook_without(text, rules):
    """The rule book in which Kelpie's have the theses' values."""
    books = values(text)
    lines = text.splitlines(keepends=True)
    for rule in rules:
        if rule not in books['Thesis'] or rule == 'THESIS':
            known = sorted(set(books['Kelpie']) - {'THESIS'})
            raise Trouble(f"--without {rule}: rules are {', '.join(known)}")
        line, value = books['Kelpie'][rule]
        lines[line] = lines[line].replace(f'{rule} = {value}',
                                          f"{rule} = {books['Thesis'][rule][1]}", 1)
    return ''.join(lines)


def task_lines(settings=()):
    """The switches of teams/kelpie, in which those of `settings` (KEY=NUMBER) are other ones."""
    switches = tomllib.loads(KELPIE.read_text(encoding='utf-8'))['behaviour']['task']
    words = {key: json.dumps(value) for key, value in switches.items()}
    words |= dict(setting.split('=') for setting in settings)
    return ['[behaviour.task]', *(f'{key} = {word}' for key, word in words.items())]


def team_toml(settings):
    for setting in settings:
        if not SETTING.fullmatch(setting):
            raise Trouble(f'--set {setting}: KEY=NUMBER, or true or false, of [behaviour.task]')
    return '\n'.join(['# SPDX-License-Identifier: Apache-2.0', '# Kelpie but for what is changed.',
                      *task_lines(settings)]) + '\n'


def write_variant(folder, rules, settings):
    """Makes the folder, which must not be there: nobody's team is overwritten."""
    folder = Path(folder)
    if folder.exists():
        raise Trouble(f'{folder}: is there already')
    if not rules and not settings:
        raise Trouble('a variant says --without or --set')
    settled = team_toml(settings)
    book = rulebook_without((PYCODE / RULES).read_text(encoding='utf-8'), rules)
    if rules:
        shutil.copytree(PYCODE, folder, ignore=shutil.ignore_patterns('__pycache__'))
        (folder / RULES).write_text(book, encoding='utf-8')
    folder.mkdir(parents=True, exist_ok=True)
    (folder / 'team.toml').write_text(settled, encoding='utf-8')
    return folder
