# SPDX-License-Identifier: Apache-2.0
"""The layers of pycode/, read from its text: main -> players -> roles -> decisions -> skills ->
safety -> situation -> arbiter -> lib -> data, and nothing else but `kelpie` and `math`."""
import ast
import pathlib
import re

import pytest

PYCODE = pathlib.Path(__file__).resolve().parent.parent.parent / 'pycode'
FILES = sorted(PYCODE.rglob('*.py'))
# A file may import from its own layer and those before it.
LAYERS = ('data', 'lib', 'arbiter', 'situation', 'safety', 'skills', 'decisions', 'roles',
          'players', 'main')
SHARED = ('kelpie', 'math')
FUNCTION_LINES = 40
# One verb for all: what a skill, a role or a player answers is what its folder moves.
STEP_ANSWERS = {'skills/head': ('kelpie.HeadRequest',), 'skills/motion': ('int',),
                'skills/walk': ('kelpie.WalkRequest', 'kelpie.Command'),
                'skills/ball': ('kelpie.WalkRequest', 'kelpie.Command'),
                'roles': ('kelpie.Command',), 'players': ('kelpie.Command',)}
OLD_VERBS = ('walk', 'head', 'command', 'motion', 'answer', 'tick')


def imports(tree):
    """Every module that a file imports, by its full name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or '.'


def upward_imports(layer, text):
    allowed = SHARED + LAYERS[:LAYERS.index(layer) + 1]
    return [name for name in imports(ast.parse(text)) if name.split('.')[0] not in allowed]


def functions(path):
    tree = ast.parse(path.read_text())
    return [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]


def name_of(path):
    return path.relative_to(PYCODE).as_posix()


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_a_file_imports_nothing_of_the_layers_above_it(path):
    layer = path.relative_to(PYCODE).parts[0].removesuffix('.py')
    assert upward_imports(layer, path.read_text()) == []


@pytest.mark.parametrize('layer, text, found', [
    ('lib', 'import math\nfrom lib.geom import clamp', []),
    ('lib', 'from skills.motion.kick import Kick', ['skills.motion.kick']),
    ('lib', 'def late():\n    import players.forward', ['players.forward']),
    ('skills', 'from lib import geom\nfrom players import forward', ['players']),
    ('skills', 'from decisions import tree', ['decisions']),
    ('decisions', 'from roles.attacker import Attacker', ['roles.attacker']),
    ('roles', 'from decisions import tree', []),
    ('skills', 'import os.path', ['os.path']),
    ('players', 'from main import decide', ['main']),
    ('players', 'from .forward import Forward', ['forward'])])
def test_an_import_upwards_is_found(layer, text, found):
    assert upward_imports(layer, text) == found


def steps(path):
    """(class, its step()) of what is played: all but the parts that a skill is made of."""
    for one in ast.walk(ast.parse(path.read_text())):
        if isinstance(one, ast.ClassDef):
            yield from ((one, each) for each in one.body
                        if isinstance(each, ast.FunctionDef) and each.name == 'step')


PLAYED = [path for path in FILES if name_of(path).startswith(tuple(STEP_ANSWERS))]


@pytest.mark.parametrize('path', PLAYED, ids=name_of)
def test_one_verb_says_what_is_played_in_this_frame(path):
    folder = path.relative_to(PYCODE).parent.as_posix()
    for one, step in steps(path):
        arguments = [each.arg for each in step.args.args]
        assert arguments[:2] == ['self', 'world'] and len(arguments) <= 3, one.name
        assert one.bases, f'{one.name} is no Skill'
        returned = step.returns is not None and ast.unparse(step.returns)
        assert returned in STEP_ANSWERS[folder], one.name
    for function in functions(path):
        assert function.name not in OLD_VERBS, f'line {function.lineno}: say step'


@pytest.mark.parametrize('path', PLAYED, ids=name_of)
def test_done_and_committed_are_asked_without_arguments(path):
    for function in functions(path):
        if function.name in ('done', 'committed'):
            assert [ast.unparse(one) for one in function.decorator_list] == ['property']


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_functions_are_short(path):
    long = [f.name for f in functions(path) if f.end_lineno - f.lineno >= FUNCTION_LINES]
    assert long == []


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_file_names_are_whole_words_and_their_first_lines_say_what_they_keep(path):
    for part in path.relative_to(PYCODE).parts:
        assert re.fullmatch(r'[a-z]+(_[a-z]+)*', part.split('.')[0])
    lines = path.read_text().splitlines()
    assert lines[0] == '# SPDX-License-Identifier: Apache-2.0' and lines[1].startswith('# ')
