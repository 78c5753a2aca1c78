# SPDX-License-Identifier: Apache-2.0
"""docs/howto.md: its recipes of Python are done in a copy of the tree as the page says, and every
file that a recipe names is there. Nothing is built."""

import os
import re
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

BUILD = ROOT / "build/host"    # where the stand-in for the module `kelpie` is
PAGE = (ROOT / "docs/howto.md").read_text()
RECIPES = {text.splitlines()[0].removeprefix("## "): text
           for text in re.split(r"^(?=## )", PAGE, flags=re.M)[1:]}
# "Write `path`:", and the block that follows.
STEP = re.compile(r"Write\s+`([\w./]+)`:\s*```python\n(.*?)```", re.S)
ENTRY = re.compile(r"add to `SKILLS` of `(pycode/[\w./]+)` a line\s+`'(\w+)': (.*?(\w+)\(\)),`")
EDIT = re.compile(r"`([A-Z]+ = [\d.]+)` in place of `([A-Z]+ = [\d.]+)`")
PATH = re.compile(r"`((?:\w+/)+[\w.]*)`")
# What `kelpie vectors` asks of one skill: its first step, with the ball 40 deg to the left.
FIRST_STEP = """
import sys
sys.path[:0] = ["pycode", "tests/py", sys.argv[2]]
import kelpie, main
world = kelpie.WorldFrame(field=kelpie.FIELDS["2006"])
world.task.player, world.task.skill = kelpie.ONE_SKILL, main.skill_names().index(sys.argv[1])
world.ball.present, world.ball.heading_deg = True, 40.0
print(main.decide(world).walk.turn_deg)
"""


def steps(recipe):
    return STEP.findall(RECIPES[recipe])


def written_by_a_recipe():
    return {path for text in RECIPES.values() for path, _ in STEP.findall(text)}


def named_paths(text):
    prose = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    return set(PATH.findall(prose)) - written_by_a_recipe()


def run(place, *words):
    return subprocess.run([sys.executable, *words], cwd=place, capture_output=True, text=True,
                          timeout=120, check=False,
                          env={**os.environ, "KELPIE_BUILD": str(BUILD)})


@pytest.fixture(scope="module", name="done")
def tree_in_which_the_recipes_are_done(tmp_path_factory):
    place = tmp_path_factory.mktemp("howto")
    for folder in ("pycode", "tests/py"):
        shutil.copytree(ROOT / folder, place / folder,
                        ignore=shutil.ignore_patterns("__pycache__"))
    for path, text in steps("A skill"):
        (place / path).write_text(text)
    register(place)
    return place


def register(place):
    """The line of SKILLS, and the import that it wants."""
    path, name, maker, kind = ENTRY.search(RECIPES["A skill"]).groups()
    module = steps("A skill")[0][0].removeprefix("pycode/").removesuffix(".py").replace("/", ".")
    text = (place / path).read_text()
    assert text.count("SKILLS = {\n") == 1
    text = text.replace("SKILLS = {\n", f"SKILLS = {{\n    '{name}': {maker},\n")
    (place / path).write_text(text.replace("import kelpie\n",
                                           f"import kelpie\nfrom {module} import {kind}\n", 1))


def first_step(place):
    """deg/s of the new skill's first turn, by the player that plays one skill alone."""
    result = run(place, "-c", FIRST_STEP, ENTRY.search(RECIPES["A skill"]).group(2),
                 BUILD / "generated/python")
    assert result.returncode == 0, result.stderr
    return float(result.stdout)


def test_the_page_has_a_recipe_for_each_thing_that_is_added_often():
    assert list(RECIPES) == ["A skill", "A number, a parameter", "A field of the log", "A kick",
                             "A role", "An experiment"]


@pytest.mark.parametrize("recipe", RECIPES)
def test_a_file_that_a_recipe_names_is_there(recipe):
    named = named_paths(RECIPES[recipe])
    assert len(named) >= 3
    assert [path for path in sorted(named) if not (ROOT / path).exists()] == []


def test_what_a_recipe_writes_is_not_there_yet():
    assert len(written_by_a_recipe()) == 2
    assert [path for path in written_by_a_recipe() if (ROOT / path).exists()] == []


def test_the_test_of_the_new_skill_passes(done):
    path = next(path for path, _ in steps("A skill") if path.startswith("tests/"))
    result = run(done, "-m", "pytest", "-q", "-p", "no:cacheprovider", path)
    assert result.returncode == 0 and "1 passed" in result.stdout, result.stdout


def test_the_new_skill_keeps_to_the_house_rules_of_the_behaviours(done):
    result = run(done, "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/py/test_structure.py")
    assert result.returncode == 0, result.stdout


def test_the_new_skill_can_be_drawn_and_a_number_of_it_edited(done):
    path = done / steps("A skill")[0][0]
    after, before = EDIT.search(RECIPES["A number, a parameter"]).groups()
    text = path.read_text()
    slow = first_step(done)
    assert slow > 0.0 and text.count(before) == 1
    path.write_text(text.replace(before, after))
    assert first_step(done) == pytest.approx(2.0 * slow)
