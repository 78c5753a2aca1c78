# SPDX-License-Identifier: Apache-2.0
"""A team of four under a bad radio: against four, a fifth of the packets lost and all of them late
by 100 ms; against a goalie, a robot that is heard and hears nothing. The team still plays as one:
one attacker most of the time, mates known, nobody dies."""

import json

import pytest
from conftest import kelpie

FORWARDS = ("red-1", "match", "red-3", "red-4")  # the watched one is red 2


def played(out, robots, *words):
    """{log: its frames while the game is played}"""
    result = kelpie("play", "--robots", robots, "--seconds", "36", "--fast", "--logs", "all",
                    "--no-film", "--seed", "5311", "--out", out, *words)
    assert result.returncode == 0, result.stderr
    assert "died" not in result.stderr and "gave up" not in result.stderr
    frames = {}
    for name in FORWARDS:
        lines = kelpie("replay", out / f"{name}.mcap", "--jsonl", "-").stdout.splitlines()
        frames[name] = [frame for frame in map(json.loads, lines)
                        if frame["game"]["state"] == "playing"]
        assert len(frames[name]) > 1000
    return frames


@pytest.fixture(scope="module")
def bad(tmp_path_factory):
    return played(tmp_path_factory.mktemp("bad"), "4v4", "--radio-loss", "0.2", "--radio-delay",
                  "0.1")


@pytest.fixture(scope="module")
def one_way(tmp_path_factory):
    return played(tmp_path_factory.mktemp("one_way"), "4v1", "--deaf", "red:3")


def attackers(frames):
    """How many red robots are the attacker in each frame, of those that are in all logs."""
    at = {}
    for log in frames.values():
        for frame in log:
            is_one = any(step["layer"] == "player" and step["branch"] == "attacker"
                         for step in frame["command"]["trace"])
            at.setdefault(frame["frame"], []).append(is_one)
    return [sum(robots) for robots in at.values() if len(robots) == len(frames)]


def test_a_team_that_hears_little_and_late_has_one_attacker(bad):
    counts = attackers(bad)
    assert len(counts) > 1000
    assert counts.count(1) / len(counts) > 0.8
    assert counts.count(2) / len(counts) < 0.1


def test_a_team_that_hears_little_and_late_knows_its_mates(bad):
    known = [len(frame["teammates"]) for log in bad.values() for frame in log]
    assert known.count(3) / len(known) > 0.95


def test_a_deaf_robot_knows_nobody_and_plays(one_way):
    assert all(frame["teammates"] == [] for frame in one_way["red-3"])
    reasons = {step["branch"] for frame in one_way["red-3"] for step in frame["command"]["trace"]
               if step["layer"] == "player"}
    assert reasons - {"waits", "takes_place"}


def test_the_others_hear_the_deaf_one(one_way):
    for name in ("red-1", "match", "red-4"):
        heard = [any(mate["player"] == 3 for mate in frame["teammates"])
                 for frame in one_way[name]]
        assert sum(heard) / len(heard) > 0.95


def test_a_robot_that_is_not_there_cannot_be_deaf(tmp_path):
    result = kelpie("play", "--deaf", "blue:4", "--out", tmp_path / "out")
    assert result.returncode == 2 and "no blue 4 is there to be deaf" in result.stderr
