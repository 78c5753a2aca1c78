# SPDX-License-Identifier: Apache-2.0
"""Small changes of a Python file that its tests should notice, one each: numbers, comparisons,
signs, logic and branches. A change replaces one expression's text; the rest of the file stays as it
is. What nobody can notice is left out: docstrings, annotations, texts, and the numbers that say how
a text is drawn."""

import ast
import copy
from typing import NamedTuple

COMPARED = {ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq,
            ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn,
            ast.NotIn: ast.In}
COMPUTED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
            ast.Mod: ast.Mult}


class Mutant(NamedTuple):
    file: str      # below the folder of the behaviours
    line: int
    kind: str      # number, comparison, sign, logic, branch
    before: str    # text of the expression
    after: str
    start: int     # offsets in the file's text
    end: int
    name: str      # of the constant at module level that it belongs to, or ''

    @property
    def id(self):
        return f'{self.file}:{self.line}: {self.kind}: {self.before} -> {self.after}'

    def applied(self, text):
        return text[:self.start] + self.after + text[self.end:]


def number_mutations(value):
    """Other numbers: far enough off that a rule with it is another rule."""
    if value == 0:
        return (type(value)(1),)
    if isinstance(value, int):
        return (value * 2, 0) if abs(value) > 1 else (2, 0)
    return value * 2.0, value * 0.5, 0.0


def other(node):
    """(kind, changed node) of each change of this node alone."""
    if isinstance(node, ast.Constant) and type(node.value) is bool:
        yield 'logic', ast.Constant(not node.value)
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
        for value in number_mutations(node.value):
            yield 'number', ast.Constant(value)
    elif isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in COMPARED:
        changed = copy.deepcopy(node)
        changed.ops = [COMPARED[type(node.ops[0])]()]
        yield 'comparison', changed
    elif isinstance(node, ast.BinOp) and type(node.op) in COMPUTED:
        changed = copy.deepcopy(node)
        changed.op = COMPUTED[type(node.op)]()
        yield 'sign', changed
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield 'sign', node.operand
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield 'logic', node.operand
    elif isinstance(node, ast.BoolOp):
        changed = copy.deepcopy(node)
        changed.op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield 'logic', changed
    elif isinstance(node, ast.IfExp):
        yield 'branch', ast.IfExp(node.test, node.orelse, node.body)


def left_out(tree):
    """Nodes that nobody asks: annotations, docstrings, texts with their formats."""
    found = set()
    for node in ast.walk(tree):
        hidden = []
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            hidden.append(node.returns)
        hidden.append(getattr(node, 'annotation', None))
        if isinstance(node, (ast.JoinedStr, ast.FormattedValue)):
            hidden.append(node)
        for each in hidden:
            if isinstance(each, ast.AST):
                found.update(id(inner) for inner in ast.walk(each))
    return found


def module_names(tree):
    """By the number of each line of a module-level assignment, the first name that it gives."""
    names = {}
    for node in tree.body:
        if isinstance(node, (ast.Assign, ast.AnnAssign)):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            first = next((n.id for n in ast.walk(target) if isinstance(n, ast.Name)), '')
            for line in range(node.lineno, node.end_lineno + 1):
                names[line] = first
    return names


def tests_of_branches(tree):
    """The tests of `if` and `while`, each to be turned round."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.If, ast.While)) and not isinstance(node.test, ast.Compare):
            yield node.test


def offsets_of(text):
    """Of each line's beginning, in characters; AST columns count bytes."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    lines = text.splitlines(keepends=True)

    def at(line, column):
        return starts[line - 1] + len(lines[line - 1].encode()[:column].decode())
    return at


def mutants_of(file, text):
    """All of a file, in its order."""
    tree = ast.parse(text)
    hidden, names, at = left_out(tree), module_names(tree), offsets_of(text)
    found = []

    def add(node, kind, after):
        start, end = at(node.lineno, node.col_offset), at(node.end_lineno, node.end_col_offset)
        found.append(Mutant(file, node.lineno, kind, text[start:end], f'({after})' if
                            kind in ('sign', 'logic', 'branch') else after, start, end,
                            names.get(node.lineno, '')))

    for node in ast.walk(tree):
        if id(node) in hidden or not hasattr(node, 'lineno'):
            continue
        for kind, changed in other(node):
            add(node, kind, ast.unparse(changed))
    for test in tests_of_branches(tree):
        add(test, 'branch', 'not (' + ast.unparse(test) + ')')
    return sorted(set(found), key=lambda mutant: (mutant.start, mutant.end, mutant.after))
