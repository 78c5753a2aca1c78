# SPDX-License-Identifier: Apache-2.0
"""Matches whose scripts eat memory, print without end, or stay in one long call of Python's own."""

import json

import pytest

from conftest import complaint, kelpie

# Does not come back in one frame or two; the next life of the robot is later than those.
ONCE = """import kelpie


def decide(world):
    if world.game.player == {player} and 1.0 < world.time_s < 1.05:
        sum(range(10 ** 10))
    return kelpie.Command(walk=kelpie.WalkRequest(forward={forward}))
"""
HUNG = "main.py:6: it does not end and cannot be broken off, so that this process ends: sum(range("
EVERY_FRAME = """import kelpie


def decide(world):
    {does}
    return kelpie.Command(walk=kelpie.WalkRequest(forward=7.0))
"""


@pytest.fixture
def scripts(tmp_path):
    def write(text):
        (tmp_path / "scripts").mkdir()
        (tmp_path / "scripts/main.py").write_text(text)
        return tmp_path / "scripts"
    return write


def played(folder, out, *words):
    return kelpie("play", "--pycode", folder, "--fast", "--seconds", "4", "--images", "planes",
                  "--no-film", "--out", out, *words)


def commands(log):
    reported = kelpie("replay", log, "--jsonl", "-").stdout
    return [json.loads(line)["command"] for line in reported.splitlines()]


def test_a_robot_whose_script_does_not_come_back_is_started_into_the_match_again(scripts, tmp_path):
    result = played(scripts(ONCE.format(player=1, forward=7.0)), tmp_path / "out")
    assert "(seed 1, 4.0 simulated seconds" in result.stdout, result.stderr
    assert result.stderr.count(HUNG) == 1, result.stderr
    assert "the agent ended with code 4; it is started again" in result.stderr
    assert "agent red 1 is there again" in result.stderr
    before, after = (commands(tmp_path / f"out/{name}.mcap") for name in ("match", "match-2"))
    assert 25 <= len(before) <= 31 and len(after) > 60
    assert all(command["walk"]["forward_cm_s"] == 7.0 for command in before + after)


def test_so_is_another_robot_than_the_watched_one(scripts, tmp_path):
    # They stand, so that no kick-off waits for them.
    folder = scripts(ONCE.format(player=2, forward=0.0))
    result = kelpie("play", "--robots", "1v2", "--fast", "--red", folder, "--blue", folder,
                    "--seconds", "8", "--no-film", "--out", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert result.stderr.count(HUNG) == 1, result.stderr
    assert "the opponent blue 2: behaviour: " in result.stderr
    assert "the opponent blue 2: it ended with code 4; it is started again" in result.stderr
    assert not (tmp_path / "out/match-2.mcap").exists()


def test_a_script_that_hangs_while_it_loads_ends_the_match_with_its_line(scripts, tmp_path):
    result = played(scripts("x = sum(range(10 ** 10))\n"), tmp_path / "out")
    assert result.returncode == 2
    assert "main.py:1: it does not end" in complaint(result)


def test_so_does_one_of_another_robot(scripts, tmp_path):
    endless = scripts("x = sum(range(10 ** 10))\n")
    result = kelpie("play", "--robots", "1v1", "--fast", "--blue", endless, "--seconds",
                    "4", "--no-film", "--out", tmp_path / "out")
    assert result.returncode == 2, result.stderr
    assert "the opponent blue 1: behaviour: " in complaint(result)


def test_a_script_that_eats_memory_is_reported_once_and_the_robot_stands(scripts, tmp_path):
    folder = scripts(EVERY_FRAME.format(does="if 1.0 < world.time_s < 2.0: x = [0] * 10 ** 9"))
    result = played(folder, tmp_path / "out")
    assert "(seed 1, 4.0 simulated seconds" in result.stdout, result.stderr
    assert result.stderr.count("main.py:5: MemoryError: it takes more memory") == 1, result.stderr
    reported = commands(tmp_path / "out/match.mcap")
    failed = [command for command in reported if command["fallback"] == 2]
    assert 25 <= len(failed) <= 31 and all(row["walk"]["forward_cm_s"] == 0.0 for row in failed)
    walked = [command for command in reported if command["walk"]["forward_cm_s"] == 7.0]
    assert len(walked) == len(reported) - len(failed)


def test_what_a_script_prints_is_shown_ten_lines_a_second(scripts, tmp_path):
    result = played(scripts(EVERY_FRAME.format(does="print('frame', world.frame)")),
                    tmp_path / "out")
    assert "behaviour: frame 0\nbehaviour: frame 1\n" in result.stderr
    assert 36 <= result.stderr.count("behaviour: frame ") <= 50, result.stderr
    assert "behaviour: print(): 20 more lines; 10 a second are shown\n" in result.stderr
