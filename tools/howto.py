#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/add-a-kick-test, add-a-role-test and add-a-field-test have in common: a scratch clone
of the commit that is checked out, in which a recipe of docs/howto.md is done; the files that it
touched by hand are counted, and the tree is built and played with. --quick builds nothing: it makes
what is generated and compiles the generated headers alone.

Exit code 0: the recipe holds; 1: it does not; 2: usage or a tree that is not whole."""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ("kelpie", "kelpie-agent", "kelpie-world", "behaviour_stand_in")


class Failed(Exception):
    pass


class Scratch:
    """A clone in which a recipe is done. Who edits it by hand says so by write() and change()."""

    def __init__(self, folder, quick):
        self.root, self.quick, self.touched = Path(folder) / "kelpie", quick, set()
        self.run("git", "clone", "-q", ROOT, self.root, cwd=ROOT)

    def run(self, *words, cwd=None):
        done = subprocess.run([str(word) for word in words], cwd=cwd or self.root, text=True,
                              capture_output=True, check=False)
        if done.returncode:
            raise Failed(f"{' '.join(map(str, words))}: exit code {done.returncode}\n"
                         f"{done.stdout[-1500:]}{done.stderr[-1500:]}")
        return done.stdout + done.stderr

    def write(self, path, text):
        self.touched.add(path)
        (self.root / path).write_text(text)

    def change(self, path, before, after):
        text = (self.root / path).read_text()
        if text.count(before) != 1:
            raise Failed(f"{path}: {before!r} stands there {text.count(before)} times")
        self.write(path, text.replace(before, after))

    def read(self, path):
        return (self.root / path).read_text()

    def generate(self):
        """The headers and names of the registry; they must compile."""
        out = self.root / "build/generated"
        self.run("/usr/bin/python3", "actuator/data/registry.py", "actuator/data/motions",
                 "robot/core/enumerations.toml", out)
        for header in ("robot/core/Enumerations.h", "actuator/MotionList.h",
                       "behaviour/PythonEnumerations.h"):
            self.run("g++", "-std=c++17", "-fsyntax-only", "-x", "c++", f"-I{out}",
                     f"-I{self.root}", out / header)
        return (out / "behaviour/PythonEnumerations.h").read_text()

    def stand_in(self):
        """The folder of a module `kelpie` that has the new names: the built one's, with the part of
        the registry in place of its own."""
        made = ROOT / "build/host/generated"
        if not (made / "python/kelpie.py").is_file():
            raise Failed("tools/build host behaviour_stand_in first")
        def names(text):
            return text.split('R"python(')[1].split(')python"')[0]
        old = names((made / "behaviour/PythonEnumerations.h").read_text())
        new = names(self.generate())
        folder = self.root / "build/stand-in"
        folder.mkdir(parents=True)
        (folder / "kelpie.py").write_text(
            (made / "python/kelpie.py").read_text().replace(old, new))
        return folder

    def python(self, code):
        """Runs a piece of Python that sees the behaviours, `kelpie` and the worlds of tests/py."""
        path = ":".join(map(str, (self.root / "pycode", self.root / "tests/py",
                                  self.root / "build/stand-in" if self.quick else
                                  self.root / "build/host/generated/python")))
        return self.run("env", f"PYTHONPATH={path}", "/usr/bin/python3", "-B", "-c", code)

    def build(self):
        if self.quick:
            self.stand_in()
        else:
            self.run("tools/build", "host", *PROGRAMS)

    def kelpie(self, *words):
        return self.run(self.root / "build/host/bin/kelpie", *words)


def main(what, maximum, recipe):
    """Does a recipe and tells what it touched; `most`: files by hand at most."""
    parser = argparse.ArgumentParser(
        description=f"Adds a {what} by docs/howto.md in a scratch clone")
    parser.add_argument("--quick", action="store_true", help="builds nothing")
    options = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory(prefix="kelpie-howto-") as folder:
            scratch = Scratch(folder, options.quick)
            says = recipe(scratch)
    except (Failed, OSError) as failed:
        print(f"a {what}: {failed}", file=sys.stderr)
        return 1
    touched = sorted(scratch.touched)
    print(f"a {what}: {len(touched)} files by hand ({', '.join(touched)}); {says}")
    if len(touched) > maximum:
        print(f"a {what}: more than {maximum} files by hand", file=sys.stderr)
        return 1
    return 0
