# SPDX-License-Identifier: Apache-2.0
"""The layers of pycode/, read from its text: main -> players -> roles -> decisions -> skills ->
safety -> situation -> arbiter -> lib -> data, and nothing else but `kelpie` and `math`."""
import ast
import pathlib
import re

import pytest
from situation.memory import WRITERS

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


def module_of(name, imported):
    """The module of pycode that `from name import imported` reads, or None."""
    for one in (f'{name}.{imported}', name):
        if (PYCODE / (one.replace('.', '/') + '.py')).is_file():
            return one
    return None


def reads(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom):
            yield from (one for each in node.names if (one := module_of(node.module, each.name)))


def test_no_module_reads_itself_by_way_of_others():
    graph = {name_of(path)[:-3].replace('/', '.'): set(reads(path)) for path in FILES}
    while leaves := {one for one, read in graph.items() if not read & set(graph)}:
        graph = {one: read for one, read in graph.items() if one not in leaves}
    assert graph == {}, 'in circles: ' + ', '.join(sorted(graph))


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


# Who writes what


def targets(path):
    """Every place that a file assigns to, with its line."""
    for node in ast.walk(ast.parse(path.read_text())):
        written = node.targets if isinstance(node, ast.Assign) else (
            [node.target] if isinstance(node, (ast.AugAssign, ast.AnnAssign)) else [])
        for target in written:
            for one in ast.walk(target):
                if isinstance(one, ast.Attribute) and isinstance(one.ctx, ast.Store):
                    yield one, node.lineno


def others_state(target):
    """Whether it is state of somebody that an object keeps: self.somebody.something, or that of a
    memory."""
    below = target.value
    return isinstance(below, ast.Attribute) or (isinstance(below, ast.Name) and
                                                below.id in ('memory', 'player', 'role', 'skill'))


MESSAGES = ('command', 'walk', 'note')    # made in this frame, and filled in by who makes them


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_no_module_writes_the_state_of_another(path):
    found = [f'line {line}: {ast.unparse(target)}' for target, line in targets(path)
             if others_state(target) and not ast.unparse(target).startswith(MESSAGES)]
    assert found == []


@pytest.mark.parametrize('text, writes', [
    ('self.memory.grab_lost = 0', True), ('memory.hint = None', True),
    ('self.eyes.seen, x = place, 1', True), ('self.goal.looked_s += 1.0', True),
    ('self.leaf = leaf', False), ('command.team.role = 1', False), ('walk.left = 0.0', False)])
def test_a_write_of_anothers_state_is_found(tmp_path, text, writes):
    (tmp_path / 'one.py').write_text(text)
    found = [target for target, _ in targets(tmp_path / 'one.py')
             if others_state(target) and not ast.unparse(target).startswith(MESSAGES)]
    assert bool(found) is writes


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_each_field_of_the_memory_has_one_writer(path):
    """A method of the memory is called by the module that WRITERS names, and by no other."""
    module = name_of(path).removesuffix('.py')
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            holder = ast.unparse(node.func.value)
            if holder in ('memory', 'self.memory') and node.func.attr != 'update':
                assert WRITERS[node.func.attr] == module, f'line {node.lineno}'


def test_all_that_the_memory_keeps_is_written_by_it_alone():
    text = (PYCODE / 'situation/memory.py').read_text()
    methods = {each.name for one in ast.walk(ast.parse(text))
               if isinstance(one, ast.ClassDef) for each in one.body
               if isinstance(each, ast.FunctionDef) and not each.name.startswith('_')}
    assert methods == set(WRITERS) | {'update'}


# Numbers


def searched(text):
    """(name, value, least, greatest) of the constants that a search may move: NAME = value with a
    comment that begins with [least, greatest]."""
    return [(name, float(value), float(low), float(high)) for name, value, low, high in re.findall(
        r'^ *([A-Z][A-Z0-9_]*) = (-?[\d.]+) +# \[(-?[\d.]+), (-?[\d.]+)\]', text, re.M)]


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_a_constant_to_be_searched_lies_within_its_bounds(path):
    text = path.read_text()
    assert len(searched(text)) == len(re.findall(r'# \[', text))
    assert all(low < value < high for _, value, low, high in searched(text))


def numbers(text):
    """Lines of the constants that are numbers, with their last line."""
    tree, lines = ast.parse(text), text.splitlines()
    bodies = [tree.body] + [one.body for one in tree.body if isinstance(one, ast.ClassDef)]
    for node in (node for body in bodies for node in body if isinstance(node, ast.Assign)):
        if isinstance(node.targets[0], ast.Name) and node.targets[0].id.isupper():
            yield node, ast.unparse(node.targets[0]), lines[node.lineno - 1]


@pytest.mark.parametrize('path', FILES, ids=name_of)
def test_a_number_stands_alone_on_its_line_with_its_unit(path):
    if path.parent.name == 'data':
        return
    lines = path.read_text().splitlines()
    for node, name, line in numbers(path.read_text()):
        if isinstance(node.value, ast.Constant) and type(node.value.value) in (int, float):
            above = lines[node.lineno - 2].lstrip().startswith('#')
            assert '#' in line or above, f'line {node.lineno}: {name} in which unit?'
        assert not isinstance(node.targets[0], ast.Tuple), f'line {node.lineno}'
