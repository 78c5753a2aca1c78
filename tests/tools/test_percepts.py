# SPDX-License-Identifier: Apache-2.0
"""Matches of percepts, without images, as a user asks for them."""

import json

import pytest
from conftest import complaint, kelpie

# Red walks, blue turns: the logs tell whose behaviours a robot had.
WALKS = """import kelpie


def decide(world):
    return kelpie.Command(walk=kelpie.WalkRequest(forward=10.0))
"""
TURNS = """import kelpie


def decide(world):
    return kelpie.Command(walk=kelpie.WalkRequest(turn_deg=40.0))
"""
BREAKS = """import kelpie


def decide(world)
    return kelpie.Command()
"""


def team(folder, text):
    folder.mkdir()
    (folder / "main.py").write_text(text)
    return folder


def match(out, *words, robots="2v2", seconds="2"):
    return kelpie("play", "--robots", robots, "--fast", "--percepts", "--seconds", seconds, "--out",
                  out, *words)


def frames(log):
    reported = kelpie("replay", log, "--jsonl", "-").stdout
    return [json.loads(line) for line in reported.splitlines()]


def test_a_match_of_percepts_tells_the_score_and_draws_its_picture(tmp_path):
    result = match(tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "red 0 : 0 blue" in result.stdout
    assert (tmp_path / "out/match.png").exists()
    assert not (tmp_path / "out/match.mp4").exists()


def test_each_team_plays_by_its_folder_and_every_robot_has_a_log(tmp_path):
    red, blue = team(tmp_path / "red", WALKS), team(tmp_path / "blue", TURNS)
    result = match(tmp_path / "out", "--red", red, "--blue", blue, "--logs", "all")
    assert result.returncode == 0, result.stderr
    for log, right, wrong in (("match", red, blue), ("blue-2", blue, red)):
        log = tmp_path / f"out/{log}.mcap"
        assert kelpie("replay", log, "--pycode", right, "--check").returncode == 0
        assert kelpie("replay", log, "--pycode", wrong, "--check").returncode == 1


def test_the_same_seed_gives_the_same_frames(tmp_path):
    logs = []
    for name in ("one", "two"):
        result = match(tmp_path / name, "--seed", "5", robots="1v1")
        assert result.returncode == 0, result.stderr
        logs.append(frames(tmp_path / name / "match.mcap"))
    assert len(logs[0]) > 100
    assert logs[0] == logs[1]


@pytest.mark.parametrize("words, lack", [
    (("--studio",), "no real time and no studio"),
    (("--randomise", "3"), "no randomised bodies and venues"),
    (("--drop-rate", "0.1"), "no images that are lost"),
    (("--radio", "udp"), "no radio but the world's"),
])
def test_what_needs_images_or_a_clock_is_refused_in_one_line(tmp_path, words, lack):
    result = match(tmp_path / "out", *words)
    assert result.returncode == 2
    assert lack in complaint(result)


@pytest.mark.parametrize("words", [("--images", "all"), ("--ring", "none")])
def test_an_option_of_images_is_refused_and_not_passed_over(tmp_path, words):
    result = match(tmp_path / "out", *words)
    assert result.returncode == 2
    assert words[0] in complaint(result) and "--percepts" in complaint(result)


def test_a_script_that_does_not_load_is_named(tmp_path):
    result = match(tmp_path / "out", "--red", team(tmp_path / "red", BREAKS))
    assert result.returncode == 2
    assert "main.py:4" in complaint(result)


def test_a_league_of_percepts_has_its_table(tmp_path):
    sides = [team(tmp_path / name, text) for name, text in (("a", WALKS), ("b", TURNS))]
    result = kelpie("league", *sides, "--percepts", "--matches", "2", "--minutes", "0.1",
                    "--robots", "1v1", "--out", tmp_path / "league")
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "league/table.txt").exists()
