# SPDX-License-Identifier: Apache-2.0
"""The one list of motions and choices: what a file must say to be listed, and what comes of it."""

import re
import shutil
import subprocess

import pytest
from conftest import ROOT

MOTIONS = "actuator/data/motions"
LISTED = "motion = { number = 23, use = \"kick\", ball = \"free\", leaf = \"nudge\" }"


@pytest.fixture
def tree(tmp_path):
    shutil.copytree(ROOT / "actuator/data", tmp_path / "actuator/data",
                    ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def made(tree):
    done = subprocess.run(
        ["/usr/bin/python3", "-B", tree / "actuator/data/registry.py", tree / MOTIONS,
         ROOT / "robot/core/enumerations.toml", tree / "out"],
        capture_output=True, text=True, check=False)
    return done.returncode, done.stderr.strip()


def nudge(tree, listed):
    text = (tree / MOTIONS / "upenn_left.toml").read_text()
    text = re.sub(r"^motion = .*$", listed, text, flags=re.M)
    (tree / MOTIONS / "nudge.toml").write_text(text)


def test_what_the_tree_has_is_listed(tree):
    assert made(tree) == (0, "")


def test_a_new_kick_is_known_to_both_sides_by_its_file_alone(tree):
    nudge(tree, LISTED)
    assert made(tree)[0] == 0
    header = (tree / "out/robot/core/Enumerations.h").read_text()
    names = (tree / "out/behaviour/PythonEnumerations.h").read_text()
    assert "grabLift, nudge }" in header and "kMotionKindCount = 24" in header
    assert "    MotionUse::kick,  // nudge" in header
    assert "GRAB_LIFT, NUDGE = range(24)" in names.replace(" \\\n    ", " ")
    assert "    NUDGE: Kick('nudge', NUDGE," in names


@pytest.mark.parametrize("listed, says", [
    ("", "nudge.toml: motion: says nothing of its number"),
    (LISTED.replace("23", "24"), "nudge.toml: motion.number: 24, where 23 is the next"),
    (LISTED.replace("23", "9"), "motion.number: 9, where"),
    (LISTED.replace('"kick"', '"shove"'), "motion.use: is one of rest, kick"),
    (LISTED.replace('ball = "free", ', ""), "motion.ball: a kick's is free, held or both"),
    (LISTED.replace("leaf", "leaves"), "motion.leaves: there is no such key"),
    (LISTED.replace("}", ', key = "6 nudge" }'), "motion.key: two have 6"),
    (LISTED.replace("}", ', key = "nudge" }'), "motion.key: is a letter and a word")])
def test_a_file_that_does_not_list_its_motion_is_refused_in_one_line(tree, listed, says):
    nudge(tree, listed)
    code, reported = made(tree)
    assert code == 1 and says in reported and "\n" not in reported


def test_a_motion_is_hurried_by_one_that_is_there(tree):
    path = tree / MOTIONS / "grab.toml"
    path.write_text(path.read_text().replace('"grab_quick"', '"grab_at_once"'))
    done = subprocess.run(
        ["/usr/bin/python3", "-B", tree / "actuator/data/compile.py", tree / "actuator/data/walks",
         tree / MOTIONS, tree / "data.cpp"], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "grab.toml: hurried_by: there is no motion grab_at_once" in done.stderr


def test_what_would_stay_the_same_is_not_written_again(tree):
    made(tree)
    header = tree / "out/robot/core/Enumerations.h"
    before = header.stat().st_mtime_ns
    made(tree)
    assert header.stat().st_mtime_ns == before


@pytest.mark.parametrize("what", ["kick", "role", "field"])
def test_a_recipe_of_the_howto_touches_few_files_and_holds(what):
    """In a clone of the commit that is checked out, without a build."""
    done = subprocess.run([ROOT / f"tools/add-a-{what}-test", "--quick"], capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert re.match(rf"a {what}.*: \d files by hand", done.stdout)
