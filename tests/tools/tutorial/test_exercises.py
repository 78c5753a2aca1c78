# SPDX-License-Identifier: Apache-2.0
"""Every exercise of docs/teach.md: its check, run as the page names it, gives the figure of the
start, and a solution, which is no part of examples/, beats the figure to beat."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT

PAGE = (ROOT / "docs/teach.md").read_text()
SOLUTIONS = ROOT / "tests/tools/exercises/solutions"
ROW = re.compile(r"^\| `(\w+)` \| (less|more) \| ([\d.]+) \| ([\d.]+) \|$", re.M)
EXERCISES = {name: (which, float(start), float(beat)) for name, which, start, beat
             in ROW.findall(PAGE)}


def figure(words):
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return float(re.fullmatch(r"[^\n]*: (-?[\d.]+)\n", done.stdout)[1])


def check_of(name):
    """The command that the page names."""
    command = f"python3 examples/exercises/{name}/check.py"
    assert PAGE.count(f"`{command}`") == 1, command
    return [sys.executable, *command.split()[1:]]


def test_the_page_has_each_folder_and_each_solution():
    folders = {path.parent.name for path in (ROOT / "examples/exercises").glob("*/check.py")}
    assert len(folders) >= 10 and folders == set(EXERCISES)
    assert {path.stem for path in SOLUTIONS.glob("*.py")} == folders


@pytest.mark.parametrize("name", EXERCISES)
def test_the_start_runs_and_gives_its_figure(name):
    assert figure(check_of(name)) == pytest.approx(EXERCISES[name][1], rel=0.02)


@pytest.mark.parametrize("name", EXERCISES)
def test_a_solution_beats_the_figure_to_beat_and_the_start_does_not(name):
    which, start, beat = EXERCISES[name]
    solved = figure([*check_of(name), SOLUTIONS / f"{name}.py"])
    assert solved < beat < start if which == "less" else solved > beat > start


def test_a_file_that_is_not_there_is_named():
    done = subprocess.run([sys.executable, "examples/exercises/filter/check.py", "none.py"],
                          cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1 and done.stderr == "none.py: no such file\n"
