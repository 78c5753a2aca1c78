# SPDX-License-Identifier: Apache-2.0
"""A game controller outside rules a match: one written here by hand, and kelpie gamecontroller."""

import json
import socket
import struct
import subprocess
import threading
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie

STANDS = """import kelpie


def decide(world):
    return kelpie.Command(walk=kelpie.WalkRequest(turn_deg=40.0))
"""
INITIAL, READY, SET, PLAYING, FINISHED = range(5)
BLUE, RED = range(2)
NO_DROP_IN = 0xffffffff


@pytest.fixture
def port():
    """One that nobody has at the moment."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


@pytest.fixture
def team(tmp_path):
    folder = tmp_path / "team"
    folder.mkdir()
    (folder / "main.py").write_text(STANDS)
    return folder


class Controller(threading.Thread):
    """Sends the packet of version 4 ten times a second. Knows nothing of Kelpie's own codec."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.port = port
        self.state, self.first_half, self.kick_off = INITIAL, 1, RED
        self.score = {BLUE: 0, RED: 0}
        self.penalties = {}  # (team, player) -> number of the penalty
        self.over = threading.Event()

    def team(self, colour, number):
        words = [number, colour, self.score[colour]]
        for player in range(1, 5):
            penalty = self.penalties.get((colour, player), 0)
            words += [penalty, 30 if penalty else 0]
        return words

    def packet(self):
        words = [4, self.state, self.first_half, self.kick_off, 600, BLUE, NO_DROP_IN]
        return b"RGme" + struct.pack("<29I", *words, *self.team(BLUE, 21), *self.team(RED, 12))

    def run(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self.over.wait(0.1):
                sender.sendto(self.packet(), ("127.0.0.1", self.port))


def started(team, out, port, seconds="120"):
    return subprocess.Popen([BIN / "kelpie", "play", "--robots", "1v1", "--fast", "--red", team,
                             "--blue", team, "--seconds", seconds, "--no-film", "--out", out,
                             "--game-controller", f"udp:{port}"],
                            stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=ROOT)


def wait_until_heard(play, lines):
    for line in play.stderr:
        lines.append(line)
        if "is heard at port" in line:
            return
    raise AssertionError("".join(lines))


def games(log):
    reported = kelpie("replay", log, "--jsonl", "-").stdout
    return [json.loads(line)["game"] for line in reported.splitlines()]


def in_order(games, key):
    """Each value once, as often as it changed."""
    values = [game[key] for game in games]
    return [v for i, v in enumerate(values) if i == 0 or v != values[i - 1]]


def end_with_a_goal_of_red(controller, play):
    """Nobody is penalised any more; the match ends as the controller says."""
    controller.penalties.clear()
    controller.score[RED] = 1
    time.sleep(1.0)
    controller.state, controller.first_half = FINISHED, 0
    output, errors = play.communicate(timeout=60)
    controller.over.set()
    assert play.returncode == 0, errors
    assert "red 1 : 0 blue" in output


def test_a_packet_has_120_bytes():
    assert len(Controller(0).packet()) == 120


def test_a_controller_outside_rules_a_match_from_ready_to_finished(team, tmp_path, port):
    controller = Controller(port)
    play = started(team, tmp_path / "out", port)
    controller.start()
    wait_until_heard(play, [])
    time.sleep(1.0)
    for state in (READY, SET, PLAYING):
        controller.state = state
        time.sleep(1.5)
    controller.penalties[RED, 1] = 3
    time.sleep(1.5)
    end_with_a_goal_of_red(controller, play)
    log = tmp_path / "out/match.mcap"
    seen = games(log)
    assert in_order(seen, "state")[:4] == ["initial", "ready", "set", "playing"]
    assert in_order(seen, "penalised") == [False, True, False]
    assert in_order(seen, "own_score") == [0, 1]
    assert [game["kick_off"] for game in seen if game["state"] == "set"][0]
    assert kelpie("replay", log, "--check", "--pycode", team).returncode == 0


def test_what_is_no_packet_is_reported_once_and_changes_nothing(team, tmp_path, port):
    play = started(team, tmp_path / "out", port, seconds="4")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        while play.poll() is None:
            for packet in (b"RGrt" + bytes(8), b"RGme\x0c" + bytes(53), b"RGme\x0a" + bytes(583),
                           Controller(port).packet()[:119]):
                sender.sendto(packet, ("127.0.0.1", port))
            time.sleep(0.05)
    lines = play.communicate()[1].splitlines()
    reported = [line for line in lines if "is not used" in line]
    plays = "Kelpie plays version 4 (120 bytes), 8 (158 bytes), 18 (118 bytes)"
    assert [line.split("is not used: ")[1] for line in reported] == [
        f"its header; {plays}", f"heard version 12, 58 bytes; {plays}",
        f"heard version 10, 256 bytes or more; {plays}", f"heard version 4, 119 bytes; {plays}"]
    assert in_order(games(tmp_path / "out/match.mcap"), "state") == ["initial"]


class LaterController(Controller):
    """Of another year; red is 12 and kicks off."""

    def __init__(self, port, version):
        super().__init__(port)
        self.version = version

    def team(self, colour, number):
        score, words = self.score[colour], [number, colour, *bytes(8)]
        penalties = [n for p in range(1, 5) for n in (self.penalties.get((colour, p), 0), 9)]
        if self.version == 8:
            return bytes([number, colour, score]) + bytes(45) + bytes(penalties) + bytes(14)
        words[4] = score
        return bytes(words) + bytes(penalties) + bytes(32)

    def packet(self):
        half, state = self.first_half, self.state
        if self.version == 8:
            head = struct.pack("<8B3h", 8, 0, 4, state, half, RED, 0, 0, -1, -5, 0)
        else:
            head = struct.pack("<10B2h", 18, 0, 4, 0, 0, 0, state, 0, half, 12, -5, 0)
        return b"RGme" + head + self.team(BLUE, 21) + self.team(RED, 12)


@pytest.mark.parametrize("version, size", [(8, 158), (18, 118)])
def test_a_program_of_later_years_rules_a_match(version, size, team, tmp_path, port):
    controller = LaterController(port, version)
    assert len(controller.packet()) == size
    play = started(team, tmp_path / "out", port)
    controller.start()
    wait_until_heard(play, [])
    for state in (READY, SET, PLAYING):
        controller.state = state
        time.sleep(1.0)
    controller.penalties[RED, 1] = 15  # by hand, which version 4 has not
    time.sleep(1.0)
    end_with_a_goal_of_red(controller, play)
    seen = games(tmp_path / "out/match.mcap")
    assert in_order(seen, "state")[:4] == ["initial", "ready", "set", "playing"]
    assert in_order(seen, "penalised") == [False, True, False]
    assert [game["kick_off"] for game in seen if game["state"] == "set"][0]


def test_the_words_of_kelpie_gamecontroller_rule_a_match(team, tmp_path, port):
    play = started(team, tmp_path / "out", port)
    words = subprocess.Popen([BIN / "kelpie", "gamecontroller", "--port", str(port)],
                             stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             text=True)
    wait_until_heard(play, [])
    said, wrong = words.communicate("ready\nwait 1\nreedy\nset\nwait 1\nplaying\nwait 1\n"
                                    "goal blue\nwait 1\nfinished\n", timeout=60)
    output, errors = play.communicate(timeout=60)
    assert words.returncode == 0
    assert len(wrong.splitlines()) == 1 and "'reedy'" in wrong
    assert "playing, red 0 : 0 blue" in said
    assert play.returncode == 0, errors
    assert "red 0 : 1 blue" in output
    states = in_order(games(tmp_path / "out/match.mcap"), "state")
    assert states[:5] == ["initial", "ready", "set", "playing", "ready"]


@pytest.mark.parametrize("where", ["tcp", "udp:", "udp:0", "udp:70000", "udp:x", "udp 38"])
def test_a_controller_that_cannot_be_heard_is_one_line(where, tmp_path):
    result = kelpie("play", "--game-controller", where, "--out", tmp_path / "out")
    assert result.returncode == 2
    assert "expected udp or udp:PORT" in complaint(result)


def test_a_port_that_is_taken_is_one_line(team, tmp_path, port):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("", port))
        play = started(team, tmp_path / "out", port)
        errors = play.communicate(timeout=60)[1]
    assert play.returncode == 2
    assert f"game controller: port {port}: Address already in use" in errors


def test_an_agent_hears_a_controller_by_itself_and_counts_what_is_not_its(tmp_path, port, team):
    """The world sends its own packets as well, which this agent does not hear."""
    world = subprocess.Popen([BIN / "kelpie-world", "--socket", tmp_path / "world", "--seconds",
                              "3", "--real-time", "--fast", "--goals", "0"])
    agent = subprocess.Popen([BIN / "kelpie-agent", "--socket", tmp_path / "world", "--fast",
                              "--log", tmp_path / "agent.mcap", "--pycode", team, "--set",
                              "game.teamNumber=12", "--game-controller", str(port)])
    controller, others = Controller(port), Controller(port)
    controller.state = SET
    others.state = FINISHED
    others.team = lambda colour, number: Controller.team(others, colour, number + 1)
    controller.start()
    others.start()
    assert agent.wait(timeout=60) == 0 and world.wait(timeout=60) == 0
    controller.over.set()
    others.over.set()
    reported = kelpie("replay", tmp_path / "agent.mcap", "--jsonl", "-").stdout.splitlines()
    frames = [json.loads(line) for line in reported]
    assert in_order([frame["game"] for frame in frames], "state")[-1] == "set"
    assert "finished" not in {frame["game"]["state"] for frame in frames}
    assert set(frames[-1]["control_refused"]) == {"foreign"}
