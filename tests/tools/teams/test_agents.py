# SPDX-License-Identifier: Apache-2.0
"""Agents that are somebody else's programs: the examples get to the ball, and nothing that such a
program does stops a match."""

import math
import os
import struct
import subprocess
import time
from pathlib import Path

import pytest
from conftest import BIN, ROOT, complaint, kelpie

EXAMPLES = {"python": f"exec /usr/bin/python3 {ROOT}/examples/agent/to_ball.py",
            "c++": f"exec {BIN}/to_ball"}
CONNECTS = """import os, socket, struct, time
world = socket.socket(socket.AF_UNIX)
world.connect(os.environ["KELPIE_SOCKET"])
me = struct.pack("<BB", os.environ["KELPIE_TEAM"] == "blue", int(os.environ["KELPIE_PLAYER"]))
world.sendall(struct.pack("<III", 0x4B4C5031, 0, 2) + me)
"""
GARBAGE = CONNECTS + "world.sendall(bytes(range(256)) * 40)\ntime.sleep(1000)\n"


@pytest.fixture
def program(tmp_path):
    def command(text):
        (tmp_path / "agent.py").write_text(text)
        return f"/usr/bin/python3 {tmp_path}/agent.py"
    return command


def play(out, *words, wait=60):
    return kelpie("play", "--fast", "--seconds", "2", "--no-film", "--agent-wait", wait, "--out",
                  out, *words)


def records(log):
    """Opcode and content of each record of a plain MCAP file."""
    data, at = log.read_bytes(), 8
    while at + 9 <= len(data):
        opcode, size = struct.unpack_from("<BQ", data, at)
        yield opcode, data[at + 9:at + 9 + size]
        at += 9 + size


def distances(log):
    """cm from the only robot to the ball in each image, by the world's truth (Truth.h)."""
    truth = None
    for opcode, content in records(log):
        if opcode == 4 and content[8:14] == b"/truth":
            truth = content[:2]
        if opcode == 5 and content[:2] == truth:
            x, y = struct.unpack_from("<2d", content, 22 + 8 + 4 + 2)
            yield math.dist((x, y), struct.unpack_from("<2d", content, 22 + 8 + 4 + 50))


def run_alone(command, folder, *words):
    """Distances of a match of one robot that such an agent plays."""
    socket, log = folder / "world", folder / "truth.mcap"
    world = subprocess.Popen([BIN / "kelpie-world", "--socket", socket, "--robots", "0",
                              "--stranger", "red:1", "--truth", log, "--plain-log",
                              "--agent-limit", "20", "--agent-wait", "60", *words])
    while not (folder / "world-red-1").exists() and world.poll() is None:
        time.sleep(0.01)
    agent = subprocess.Popen(["/bin/sh", "-c", command], env=os.environ | {
        "KELPIE_SOCKET": f"{socket}-red-1", "KELPIE_TEAM": "red", "KELPIE_PLAYER": "1"})
    assert world.wait(timeout=240) == 0
    assert agent.wait(timeout=60) == 0
    return list(distances(log))


@pytest.mark.parametrize("language", EXAMPLES)
def test_an_example_gets_nearer_to_the_ball(language, tmp_path):
    ways = run_alone(EXAMPLES[language], tmp_path, "--seconds", "8", "--place", "red:1:180,150,90",
                     "--ball", "200,280")
    assert min(ways) < ways[0] - 40


def test_an_agent_plays_each_robot_of_its_team_and_the_other_team_is_logged(tmp_path, program):
    notes = 'open(os.environ["KELPIE_TEAM"] + os.environ["KELPIE_PLAYER"], "w")\n'
    command = f"cd {tmp_path}; " + program(CONNECTS + notes + "world.recv(100)\n")
    result = play(tmp_path / "out", "--robots", "2v2", "--red-agent", command)
    assert result.returncode == 0, result.stderr
    assert {path.name for path in tmp_path.glob("red*")} == {"red1", "red2"}
    assert "/frame/output" in kelpie("info", tmp_path / "out/match.mcap").stdout


def test_a_match_of_strangers_alone_leaves_the_worlds_log(tmp_path):
    result = play(tmp_path / "out", "--red-agent", EXAMPLES["c++"])
    assert result.returncode == 0, result.stderr
    assert "what the world saw" in result.stdout
    assert "/truth" in kelpie("info", tmp_path / "out/match.mcap").stdout


@pytest.mark.parametrize("text, told", [
    (CONNECTS + "world.recv(100)\n", "connection closed by the agent at"),
    (CONNECTS + "time.sleep(1000)\n", "has not answered within 0.2 s at"),
    (GARBAGE, "bad magic"),
    ("import time\ntime.sleep(1000)\n", "has not come within 1 s; its robot stands"),
])
def test_a_program_that_does_not_play_is_told_in_one_line_and_the_match_goes_on(
        tmp_path, program, text, told):
    result = play(tmp_path / "out", "--opponent", "goalie", "--red-agent", program(text),
                  "--agent-limit", "0.2", wait=60 if text.startswith(CONNECTS) else 1)
    assert result.returncode == 0, result.stderr
    lines = [line for line in result.stderr.splitlines() if "agent red 1: " in line]
    assert len(lines) == 1 and told in lines[0], result.stderr
    assert "2.0 simulated seconds" in result.stdout


def goes_on(pid):
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


def test_what_a_program_has_started_ends_with_the_match(tmp_path, program):
    sleeps = program(CONNECTS + "time.sleep(1000)\n")
    result = play(tmp_path / "out", "--agent-limit", "0.05", "--red-agent",
                  f"sleep 1000 & echo $! >{tmp_path}/pid; {sleeps}; true")
    assert result.returncode == 0, result.stderr
    assert not goes_on(int((tmp_path / "pid").read_text()))


def test_an_agent_that_dies_is_started_again_when_asked_for(tmp_path, program):
    text = CONNECTS + "world.recv(100)\nraise SystemExit(7)\n"
    result = play(tmp_path / "out", "--red-agent", program(text), "--respawn", "--real-time")
    assert result.returncode == 0, result.stderr
    assert "agent red 1: its program ended with code 7; it is started again" in result.stderr


@pytest.mark.parametrize("name", ["no-such-program --fast", "./no/such.py"])
def test_a_program_that_is_not_there_is_refused_before_the_match(tmp_path, name):
    said = complaint(play(tmp_path / "out", "--red-agent", name))
    assert said.endswith(f"--red-agent: no program {name.split()[0]}")


def test_a_program_that_cannot_run_is_told_with_its_code(tmp_path):
    result = play(tmp_path / "out", "--red-agent", "exit 127", wait=1)
    assert result.returncode == 0, result.stderr
    lines = [line for line in result.stderr.splitlines() if line.startswith("agent red 1: ")]
    assert lines == ["agent red 1: its program ended with code 127",
                     "agent red 1: has not come within 1 s; its robot stands"]


def test_an_agent_that_dies_again_and_again_is_left_at_last_and_told(tmp_path, program):
    result = play(tmp_path / "out", "--red-agent", program("raise SystemExit(3)\n"), "--respawn",
                  wait=10)
    assert result.returncode == 0, result.stderr
    assert result.stderr.count("it is started again") == 19
    assert "with code 3, for the 20th time, and is not started again" in result.stderr


@pytest.mark.parametrize("option", ["--agent-limit", "--agent-wait"])
def test_an_option_of_agents_without_any_is_refused(tmp_path, option):
    said = complaint(kelpie("play", option, "1", "--out", tmp_path / "out"))
    assert said.endswith(f"{option} is for the agents of --red-agent and --blue-agent")


@pytest.mark.parametrize("words, told", [
    (["--percepts"], "--percepts"),
    (["--red", "teams/kelpie"], "--red"),
])
def test_what_excludes_a_command_is_one_clear_line(tmp_path, words, told):
    said = complaint(play(tmp_path / "out", "--red-agent", "true", *words))
    assert "--red-agent" in said and told in said


def test_a_command_for_a_team_without_robots_is_refused(tmp_path):
    assert complaint(play(tmp_path / "out", "--blue-agent", "true")).endswith(
        "--blue-agent: no blue robot plays (--robots 4v4)")
