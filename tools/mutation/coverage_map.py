# SPDX-License-Identifier: Apache-2.0
"""Which tests run which lines of the behaviours, found by running all of them once with Debian's
python3-coverage; kept until a file changes. A constant of a module is read by whoever runs a line
that names it."""

import ast
import hashlib
import json
import os
import subprocess
import sys

RC = """[run]
branch = False
dynamic_context = test_function
source = {pycode}
data_file = {data}
"""


def files_of(pycode):
    return sorted(path.relative_to(pycode).as_posix() for path in pycode.rglob('*.py'))


def digest(root):
    """Of everything that the map depends on."""
    made = hashlib.sha256()
    for folder in ('pycode', 'tests/py'):
        for path in sorted((root / folder).rglob('*.py')):
            made.update(path.read_bytes())
    return made.hexdigest()


def run_all(root, folder):
    """Runs every test once under coverage; exits with what failed."""
    folder.mkdir(parents=True, exist_ok=True)
    data = folder / 'coverage.data'
    (folder / 'coveragerc').write_text(RC.format(pycode=root / 'pycode', data=data))
    for old in folder.glob('coverage.data*'):
        old.unlink()
    result = subprocess.run(
        [sys.executable, '-m', 'coverage', 'run', f'--rcfile={folder / "coveragerc"}', '-m',
         'pytest', '-q', '-p', 'no:cacheprovider', '-p', 'no:xdist', str(root / 'tests/py')],
        cwd=root, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        print('mutate: the tests fail without any change:\n' + result.stdout[-2000:],
              file=sys.stderr)
        raise SystemExit(2)
    return data


def read_contexts(root, data):
    """{file: {line: [test, ...]}}; contexts are dotted names of functions."""
    import coverage
    covered = coverage.CoverageData(basename=str(data))
    covered.read()
    lines = {}
    for path in covered.measured_files():
        name = os.path.relpath(path, root / 'pycode')
        contexts = covered.contexts_by_lineno(path)
        lines[name] = {line: sorted(c for c in names if c) for line, names in contexts.items()}
    return lines


def readers_of(root):
    """{name of a module-level constant: [(file, line), ...]} of lines in functions that name it."""
    readers = {}
    for name in files_of(root / 'pycode'):
        tree = ast.parse((root / 'pycode' / name).read_text())
        for node in ast.walk(tree):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                readers.setdefault(node.id, []).append((name, node.lineno))
            if isinstance(node, ast.Attribute):
                readers.setdefault(node.attr, []).append((name, node.lineno))
    return readers


def read_map(cache):
    """What was kept, or {}: a damaged file is made anew."""
    try:
        known = json.loads(cache.read_text())
    except (OSError, ValueError):
        return {}
    return known if isinstance(known, dict) else {}


class CoverageMap:
    """Answers which test functions may notice a mutant."""

    def __init__(self, root, folder):
        cache = folder / 'map.json'
        wanted = digest(root)
        known = read_map(cache)
        if known.get('digest') != wanted:
            lines = read_contexts(root, run_all(root, folder))
            known = {'digest': wanted, 'lines': lines}
            written = folder / 'map.json.new'
            written.write_text(json.dumps(known))
            written.replace(cache)
            known = json.loads(cache.read_text())
        self.lines = known['lines']
        self.readers = readers_of(root)

    def at(self, file, line):
        return set(self.lines.get(file, {}).get(str(line), ()))

    def tests_of(self, mutant):
        """Names as coverage has them; empty: nobody runs it, or everybody does at import. So does a
        line that reads a constant for a default or for another constant."""
        found = self.at(mutant.file, mutant.line)
        if mutant.name:
            for file, line in self.readers.get(mutant.name, ()):
                reading = self.at(file, line)
                if not reading:
                    return set()
                found |= reading
        return found
