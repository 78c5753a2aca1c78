# SPDX-License-Identifier: Apache-2.0
"""The pages of the repository: their tables are whole, each page stands on its shelf, what there is
to know of the behaviours and of the commands' options stands in a page, and the way onto a robot is
told in the order in which one goes it."""

import re
import subprocess

import pytest
from conftest import ROOT, kelpie

PAGES = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, check=True, capture_output=True,
                       text=True).stdout.split()
FLASH = (ROOT / "docs/flash.md").read_text()
RULE = re.compile(r"\|(\s*:?-+:?\s*\|)+")
BEHAVIOURS = (ROOT / "docs/behaviours.md").read_text()
SHELVES = {"Guide": "guides", "Reference": "reference", "Records": "records"}
OPTION = re.compile(r"^  (?:-\w,)?(--[a-z][a-z-]+)", re.M)
SUBCOMMAND = re.compile(r"^  ([a-z-]+)  ", re.M)


def tables(text):
    """The lines of each table; those of code are none."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    return [block.splitlines() for block in re.findall(r"(?:^\|.*\|\n)+", prose, re.M)]


@pytest.mark.parametrize("page", PAGES)
def test_a_table_is_not_cut_in_two(page):
    for rows in tables((ROOT / page).read_text() + "\n"):
        assert len(rows) > 1 and RULE.fullmatch(rows[1].strip()), f"no head above {rows[0]}"


def place(text):
    assert FLASH.count(text) >= 1, text
    return FLASH.index(text)


def test_each_step_onto_a_robot_stands_after_those_that_it_needs():
    steps = ["PATH=$PWD/build/host/bin", "\n## The system", "toolchain/build-object ",
             "toolchain/link-object AGENT.BIN", "`~/field.wlan`", "--wlan ~/field.wlan",
             "--install /media/stick ", "umount /media/stick", "\n## Switch the robot on",
             "press its head for a moment", "\n## What the lights say"]
    assert sorted(steps, key=place) == steps


def test_what_the_way_onto_a_robot_names_of_the_repository_is_there():
    named = set(re.findall(r"\b((?:docs|toolchain|robot|tools)/[\w./-]*\w)", FLASH))
    assert {"toolchain/link-object", "docs/robot-contract.md", "docs/sources.md"} <= named
    assert [path for path in sorted(named)
            if not list((ROOT / path).parent.glob((ROOT / path).name + "*"))] == []


def test_a_light_of_the_face_that_is_named_has_its_place_named():
    """Or that no source has it."""
    contract = (ROOT / "docs/robot-contract.md").read_text()
    placeless = {int(number) for number in re.findall(r"\| face (\d+) \|", contract)}
    listed = {int(number) for row in re.findall(r"^\| the face, ([\d ,andorlet]+) \|", FLASH, re.M)
            for number in re.findall(r"\d+", row)}
    assert listed and all(f"Where {number} is no source at hand tells" in FLASH
                          for number in listed & placeless)


def shelf_of(page):
    """The word that a page's first paragraph begins with; results.md is written by a program."""
    if page == "docs/results.md":
        return "Records"
    return re.search(r"^# .*\n\n(\w+)", (ROOT / page).read_text()).group(1)


@pytest.mark.parametrize("page", [page for page in PAGES if page.startswith("docs/")])
def test_a_page_says_to_whom_it_speaks_and_stands_on_that_shelf_in_the_readme(page):
    rows = {row.split(":")[0].strip("| "): row
            for rows in tables((ROOT / "README.md").read_text()) for row in rows}
    assert page in rows[SHELVES[shelf_of(page)]]


def test_every_module_of_the_behaviours_has_its_place_in_the_table():
    modules = {path.stem for path in (ROOT / "pycode").rglob("*.py")} - {"main"}
    table = BEHAVIOURS.split("\n## The modules\n")[1].split("\n## ")[0]
    named = set(re.findall(r"`(\w+)`", table))
    assert len(modules) > 20 and named == modules


def test_every_switch_of_the_task_stands_in_the_table_of_options():
    header = (ROOT / "behaviour/BehaviourParams.h").read_text()
    keys = set(re.findall(r'field\("(\w+)", &Task::', header))
    rows = re.findall(r"^\| ([\w, ]+) \|", BEHAVIOURS.split("\n## Options\n")[1], re.M)
    named = {key.strip() for row in rows for key in row.split(",")} - {"key"}
    assert len(keys) > 10 and named == keys


def commands():
    """Every subcommand, those of calibrate by their whole name."""
    for name in SUBCOMMAND.findall(kelpie("--help").stdout):
        inner = SUBCOMMAND.findall(kelpie(name, "--help").stdout) if name == "calibrate" else [""]
        yield from (f"{name} {one}".split() for one in inner)


def test_every_option_of_a_command_stands_in_a_page():
    text = "".join((ROOT / page).read_text() for page in PAGES)
    named = set(re.findall(r"--[a-z][a-z-]+", text)) | {"--help", "--version"}
    unnamed = {(" ".join(words), option) for words in commands()
               for option in OPTION.findall(kelpie(*words, "--help").stdout)
               if option not in named}
    assert unnamed == set()
