# SPDX-License-Identifier: Apache-2.0
"""`kelpie evaluate thesis-rules`: its table of the theses' rules, and that each is played."""

import json
import re

import pytest
from conftest import ROOT, kelpie

TABLE = json.loads((ROOT / "tools/experiments/team/thesis_rules.json").read_text())
MISSION = sorted((ROOT.parent / "shared/spec").glob("check*.md"))   # the theses row by row
ROW = re.compile(r"^\| ((?:A-[456]|B-4)\.[0-9.]*[0-9]) \|", re.MULTILINE)


# A goal that the pose faces and nobody sees: its scene brings it on 1 of 4 seeds
# (kelpie evaluate thesis-scenes --fast --trials 4 --seed 300).
RARE = {"A-6.4.3.1"}


def test_it_has_every_row_of_the_theses_behaviours():
    if not MISSION:
        pytest.skip("the theses row by row are not beside this tree")
    rows = ROW.findall(MISSION[0].read_text())
    assert len(rows) > 150
    assert sorted(row["id"] for row in TABLE["rules"]) == sorted(rows)


@pytest.mark.parametrize("row", TABLE["rules"], ids=lambda row: row["id"])
def test_a_row_has_the_steps_that_show_it_or_says_why_nobody_plays_it(row):
    assert bool(row.get("steps")) != bool(row.get("unplayed"))


def test_each_scene_is_of_some_row_and_each_row_s_scene_is_there():
    scenes = [scene["name"] for scene in TABLE["scenes"]]
    assert len(set(scenes)) == len(scenes)
    assert {row["scene"] for row in TABLE["rules"] if "scene" in row} == set(scenes)


def test_what_does_not_come_in_a_match_comes_in_its_scene(tmp_path):
    out = tmp_path / "rules.json"
    result = kelpie("evaluate", "thesis-rules", "--fast", "--minutes", "1", "--seed", "3",
                    "--json", out, timeout=900)
    assert result.returncode == 0, result.stderr
    figures = json.loads(out.read_text())
    assert set(figures["nowhere"]) <= RARE
    assert figures["played_in_match"] > 90
    rows = {row["id"]: row for row in figures["rows"]}
    assert rows["A-4.1.1"]["times_per_match"] == 8       # robots, each in one stretch of frames
    assert rows["B-4.1.4.1"]["times_per_match"] == 0     # nobody is a challenger in a match,
    assert rows["B-4.1.4.1"]["times_in_scene"] == 1      # who is carried away once
    assert rows["A-5.6.1"]["not_played"].startswith("FAILED")


def test_scenes_alone_have_seconds_of_their_own_and_take_no_minutes():
    result = kelpie("evaluate", "thesis-scenes", "--minutes", "1")
    assert result.returncode == 2
    assert "thesis-scenes does not use --minutes" in result.stderr


def test_what_comes_again_in_a_scene_comes_before_its_end():
    for scene in TABLE["scenes"]:
        assert 0 <= scene.get("again", 0) < scene.get("seconds", 20), scene["name"]
