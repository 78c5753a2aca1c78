# SPDX-License-Identifier: Apache-2.0
"""Matches with several robots, places of one's own and thrown balls, as a user asks for them."""

import os
import signal
import subprocess
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie

STANDS = "import kelpie\n\n\ndef decide(world):\n    return kelpie.Command()\n"


@pytest.fixture
def standing(tmp_path):
    folder = tmp_path / "standing"
    folder.mkdir()
    (folder / "main.py").write_text(STANDS)
    return folder


@pytest.mark.parametrize("opponent", ["goalie", "goalie-2004"])
def test_an_opponent_keeps_the_other_goal_and_is_not_logged(opponent, standing, tmp_path):
    result = kelpie("play", "--opponent", opponent, "--pycode", standing, "--seconds", "2",
                    "--no-film", "--out", tmp_path / "out")
    assert result.returncode == 0 and "no goal in 2 s" in result.stdout, result.stderr
    reported = kelpie("info", tmp_path / "out/match.mcap").stdout
    topics = {line.split()[0]: line.split()[2] for line in reported.splitlines()
              if line.startswith("/")}
    assert topics["/frame/output"] == topics["/truth"] == "60"
    assert kelpie("replay", tmp_path / "out/match.mcap", "--check", "--pycode",
                  standing).returncode == 0


def test_the_opponent_is_kelpies_goalie_whatever_plays_against_it(tmp_path):
    (tmp_path / "team").mkdir()
    (tmp_path / "team/main.py").write_text(
        STANDS.replace("    return", "    assert world.task.player == kelpie.FORWARD\n    return"))
    for way in ([], ["--fast", "--percepts"]):
        result = kelpie("play", "--opponent", "goalie", "--pycode", tmp_path / "team", "--seconds",
                        "1", "--no-film", "--out", tmp_path / "out", *way)
        assert result.returncode == 0 and "behaviour:" not in result.stderr, result.stderr


def test_the_same_seed_with_an_opponent_is_the_same_match(standing, tmp_path):
    logs = []
    for name in ("a", "b"):
        kelpie("play", "--opponent", "goalie", "--pycode", standing, "--seconds", "2", "--no-film",
               "--out", tmp_path / name)
        logs.append(kelpie("replay", tmp_path / name / "match.mcap", "--jsonl", "-").stdout)
    assert logs[0] == logs[1] and logs[0].count("\n") == 60


def agents_of(play):
    listing = subprocess.run(["pgrep", "-a", "-P", str(play.pid), "kelpie-agent"],
                             capture_output=True, text=True, check=False).stdout.splitlines()
    return {line.split(" --team ")[1].split()[0]: int(line.split()[0]) for line in listing}


def test_an_opponent_that_dies_ends_the_match_with_one_line_that_names_it(standing, tmp_path):
    out = tmp_path / "out"
    play = subprocess.Popen([BIN / "kelpie", "play", "--opponent", "goalie", "--pycode", standing,
                             "--seconds", "600", "--no-film", "--out", out],
                            stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, cwd=ROOT,
                            env=dict(os.environ, TMPDIR=str(tmp_path)))
    for _ in range(100):
        if len(agents_of(play)) == 2:
            break
        time.sleep(0.1)
    time.sleep(1.0)
    os.kill(agents_of(play)["blue"], signal.SIGKILL)
    _, errors = play.communicate(timeout=60)
    assert play.returncode == 3
    lines = [line for line in errors.splitlines() if not line.startswith(("playing", "log:"))]
    assert len(lines) == 1, errors
    assert "the opponent blue 1 died (signal 9); last: " in lines[0]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out", "standing"]


@pytest.mark.parametrize("words, reported", [
    (["--opponent", "keeper"], "keeper"),
    (["--opponent", "goalie", "--red", "teams/kelpie"], "--opponent"),
    (["--place", "red:1:180"], "TEAM:PLAYER:X,Y,DEG"),
    (["--place", "red:1:400,100,0"], "red 1 at (400, 100) is off the field"),
    (["--place", "blue:1:180,100,0"], "no blue 1 is there"),
    (["--ball", "180,541"], "the ball at (180, 541) is off the field"),
    (["--throw", "1:2,3"], "T:X,Y,VX,VY"),
    (["--throw", "1:0,20,0,0:blue:1"], "no blue 1 is there"),
    (["--set", "behaviour.task.grap=false"], "unknown key behaviour.task.grap"),
    (["--set", "behaviour.task.grab=maybe"], "behaviour.task.grab=maybe"),
    (["--set", "behaviour.task.player=9"], "behaviour.task.player"),
])
def test_what_cannot_be_played_is_refused_before_it_starts(words, reported, tmp_path):
    result = kelpie("play", *words, "--out", tmp_path / "out")
    assert result.returncode == 2
    assert reported in complaint(result) and result.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_the_world_refuses_what_cannot_be_played_too(tmp_path):
    for words in (["--place", "red"], ["--ball", "1"], ["--throw", "x"]):
        result = subprocess.run([BIN / "kelpie-world", "--socket", tmp_path / "s", *words],
                                capture_output=True, text=True, timeout=20, check=False)
        assert result.returncode == 1
        assert result.stderr.startswith("kelpie-world: ") and result.stderr.count("\n") == 1
