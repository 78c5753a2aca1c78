# SPDX-License-Identifier: Apache-2.0
"""The pages of the repository: their tables are whole, and the way onto a robot is told in the
order in which one goes it."""

import re
import subprocess

import pytest
from conftest import ROOT

PAGES = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, check=True, capture_output=True,
                       text=True).stdout.split()
FLASH = (ROOT / "docs/flash.md").read_text()
RULE = re.compile(r"\|(\s*:?-+:?\s*\|)+")


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


def test_a_light_of_the_face_that_is_told_has_its_place_told():
    """Or that no source has it."""
    contract = (ROOT / "docs/robot-contract.md").read_text()
    placeless = {int(number) for number in re.findall(r"\| face (\d+) \|", contract)}
    told = {int(number) for row in re.findall(r"^\| the face, ([\d ,andorlet]+) \|", FLASH, re.M)
            for number in re.findall(r"\d+", row)}
    assert told and all(f"Where {number} is no source at hand tells" in FLASH
                        for number in told & placeless)
