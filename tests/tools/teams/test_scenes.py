# SPDX-License-Identifier: Apache-2.0
"""Scenes: situations of a match that a seed draws, as a user asks for them."""

import json

import pytest
from conftest import ROOT, complaint, kelpie

STANDS = """import kelpie


def decide(world):
    return kelpie.Command()
"""


@pytest.fixture
def statues(tmp_path):
    folder = tmp_path / "statues"
    folder.mkdir()
    (folder / "main.py").write_text(STANDS)
    return folder


def once(red, blue, kind, seed):
    done = kelpie("league", red, blue, "--once", "--percepts", "--scene", kind, "--seed", seed)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_before_a_goalie_that_stands_a_team_scores_and_the_scene_is_over(statues):
    scenes = [once(ROOT / "teams/kelpie", statues, "goalie-one", seed) for seed in range(4)]
    assert sum(scene["red_goals"] for scene in scenes) >= 2
    assert all(scene["seconds"] < 15.0 for scene in scenes if scene["red_goals"])
    assert all(scene["blue_goals"] == 0 for scene in scenes)


def test_statues_play_all_of_its_time_without_a_kick_off(statues, tmp_path):
    other = tmp_path / "others"
    other.mkdir()
    (other / "main.py").write_text(STANDS)
    scene = once(statues, other, "own-box", 1)
    assert (scene["red_goals"], scene["blue_goals"], scene["seconds"]) == (0, 0, 15.0)


def test_a_scene_is_watched_like_a_match(statues, tmp_path):
    done = kelpie("play", "--scene", "edge", "--percepts", "--fast", "--red", statues, "--blue",
                  statues, "--seed", 3, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert "seed 3, 15.0 simulated seconds" in done.stdout
    assert (tmp_path / "out/match.png").is_file()


@pytest.mark.parametrize("words, said", [
    (["--scene", "party"], "party"),
    (["--scene", "edge", "--robots", "4v4"], "excludes"),
    (["--scene", "edge", "--ball", "1,1"], "excludes"),
])
def test_what_a_scene_cannot_be_is_refused_in_a_line(words, said, tmp_path):
    assert said in complaint(kelpie("play", "--percepts", "--out", tmp_path / "out", *words))


def test_a_league_has_scenes_only_once(tmp_path):
    said = complaint(kelpie("league", ROOT / "teams/kelpie", ROOT / "teams/thesis", "--scene",
                            "edge", "--out", tmp_path / "out"))
    assert "--scene requires --once" in said


CARRIES = """import kelpie


def decide(world):
    assert world.field.rules.holding_distance == {distance}
    return kelpie.Command()
"""


@pytest.mark.parametrize("rules, distance", [("2005", 500.0), ("2006", 50.0)])
def test_behaviours_know_by_which_year_s_rules_a_ball_is_held(tmp_path, rules, distance):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "main.py").write_text(CARRIES.format(distance=distance))
    done = kelpie("league", tmp_path / "one", tmp_path / "two", "--once", "--percepts", "--scene",
                  "edge", "--rules", rules)
    assert done.returncode == 0 and "AssertionError" not in done.stderr
    assert ("rules of 2005" in done.stdout) == (rules == "2005")
