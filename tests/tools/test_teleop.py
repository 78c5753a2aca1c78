# SPDX-License-Identifier: Apache-2.0
"""Driving with keys: from a file, from a pipe and at a terminal. What was driven is a log that
replays with the same bits; the terminal is as before however the drive ends."""

import fcntl
import json
import math
import os
import pty
import re
import select
import shutil
import signal
import struct
import subprocess
import termios
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie
from test_play import agent_of

# MotionKind and WalkKind of robot/core/types/Command.h
KICK_FORWARD, GRAB, CHEER = 3, 13, 21
DRIBBLE = 3
BLOCK = "\u2580".encode()


def drive(keys, out, *words, timeout=240):
    file = out / "keys.txt"
    file.write_text(keys)
    return kelpie("teleop", "--keys", file, "--out", out, *words, timeout=timeout)


def frames_of(log):
    result = kelpie("replay", log, "--check", "--jsonl", "-")
    assert result.returncode == 0, result.stderr  # the outputs have the same bits
    return [json.loads(line) for line in result.stdout.splitlines()]


JUMP = 10.0  # cm a frame; a robot walks 1


def walked(frames, start, end):
    """cm that it believes to have come along its heading. Belief jumps between hypotheses while it
    does not yet know its place; that is no walk."""
    poses = [frame["pose"] for frame in frames if start <= frame["t_s"] <= end]
    way = 0.0
    for a, b in zip(poses, poses[1:]):
        dx, dy = b["x_cm"] - a["x_cm"], b["y_cm"] - a["y_cm"]
        if math.hypot(dx, dy) < JUMP:
            heading = math.radians(a["heading_deg"])
            way += dx * math.cos(heading) + dy * math.sin(heading)
    return abs(way)


@pytest.fixture(scope="module", name="driven")
def log_of_a_drive(tmp_path_factory):
    """Looks round for five seconds, walks 20 cm/s for three, stops, kicks, cheers."""
    out = tmp_path_factory.mktemp("driven")
    keys = "1 j\n1 j\n1 j\n2 m\n2 l\n2 l\n2 l\n3 m\n" + "5 up\n" * 4 + "8 space\n9 1\n9.1 c\n13 x\n"
    result = drive(keys, out, "--seed", "5")
    assert result.returncode == 0, result.stdout + result.stderr
    return out / "teleop.mcap"


def test_robot_goes_where_the_keys_tell_it(driven):
    frames = frames_of(driven)
    walks = [frame["command"]["walk"]["forward_cm_s"] for frame in frames]
    assert {walk for walk in walks} == {0.0, 20.0}
    assert 88 <= walks.count(20.0) <= 91  # frames of three seconds
    assert 40 < walked(frames, 4.9, 9.0) < 90
    assert walked(frames, 9.0, 12.0) < 15
    assert all(frame["command"]["fallback"] == 0 for frame in frames)


def test_a_motion_is_asked_for_until_it_runs_and_the_next_waits(driven):
    motions = [frame["command"]["motion"] for frame in frames_of(driven)]
    kicks = [i for i, motion in enumerate(motions) if motion == KICK_FORWARD]
    cheers = [i for i, motion in enumerate(motions) if motion == CHEER]
    assert 0 < len(kicks) < 30 and 0 < len(cheers) < 30
    assert cheers[0] > kicks[-1] + 7  # the kick takes eight


def test_the_log_of_a_drive_is_read_by_the_other_commands(driven, tmp_path):
    info = kelpie("info", driven).stdout
    for topic in ("/frame/input", "/frame/output", "/motion/output", "/truth"):
        assert topic in info
    assert kelpie("show", driven, "--frame", 200, "--out", tmp_path / "f.png").returncode == 0
    assert kelpie("film", driven, tmp_path / "f.mp4").returncode == 0
    assert kelpie("compress", driven, "--out", tmp_path / "s.mcap").returncode == 0
    assert frames_of(tmp_path / "s.mcap")[200]["command"] == frames_of(driven)[200]["command"]


def test_the_same_keys_drive_the_same_way_again(tmp_path):
    logs = []
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        assert drive("0.5 w\n0.5 a\n1 g\n", tmp_path / name).returncode == 0
        logs.append((tmp_path / name / "teleop.mcap").read_bytes())
    assert logs[0] == logs[1]


def test_keys_of_a_pipe_drive_too_until_two_seconds_after_the_last(tmp_path):
    result = subprocess.run([BIN / "kelpie", "teleop", "--keys", "-", "--out", tmp_path], cwd=ROOT,
                            input="0.5 w\n1 space\n", text=True, capture_output=True, timeout=60,
                            check=False)
    assert result.returncode == 0, result.stderr
    assert "drove 3.0 simulated seconds" in result.stdout
    frames = frames_of(tmp_path / "teleop.mcap")
    assert {frame["command"]["walk"]["forward_cm_s"] for frame in frames} == {0.0, 5.0}


def test_the_kinematic_robot_is_driven_as_well(tmp_path):
    result = drive("1 m\n" + "2 w\n" * 4 + "5 space\n5.5 1\n", tmp_path, "--fast")
    assert result.returncode == 0, result.stderr
    frames = frames_of(tmp_path / "teleop.mcap")
    assert KICK_FORWARD in [frame["command"]["motion"] for frame in frames]
    assert walked(frames, 1.9, 5.4) > 25


def test_a_held_ball_is_carried_by_another_walk(tmp_path):
    assert drive("1 g\n4 w\n5 x\n", tmp_path).returncode == 0
    last = frames_of(tmp_path / "teleop.mcap")[-1]["command"]
    assert last["walk"]["kind"] == DRIBBLE and last["mouth_open"]


@pytest.mark.parametrize("text, why", [
    ("1 w\nsoon w\n", ":2: 'soon' is not a time"),
    ("1 w\n2 Q\n", ":2: 'Q' is not a key; kelpie teleop --help lists them"),
    ("1 w\n0.5 w\n", ":2: '0.5' is before the line above"),
    ("", ": holds no keys"),
])
def test_what_is_wrong_with_a_file_of_keys_is_one_line(text, why, tmp_path):
    result = drive(text, tmp_path)
    assert result.returncode == 2 and why in complaint(result)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["keys.txt"]


def test_a_file_that_is_not_there_and_no_terminal_are_reported(tmp_path):
    gone = kelpie("teleop", "--keys", tmp_path / "gone", "--out", tmp_path)
    assert gone.returncode == 2 and "gone: cannot be read" in complaint(gone)
    nobody = subprocess.run([BIN / "kelpie", "teleop", "--out", tmp_path], text=True, timeout=60,
                            stdin=subprocess.DEVNULL, capture_output=True, check=False)
    assert nobody.returncode == 2 and "--keys FILE" in complaint(nobody)


def test_a_drive_by_a_file_that_is_interrupted_fails_and_keeps_its_log(tmp_path):
    (tmp_path / "k").write_text("1 w\n3000 s\n")
    words = ["teleop", "--keys", tmp_path / "k", "--out", tmp_path]
    command = subprocess.Popen([BIN / "kelpie", *words], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    agent_of(command)
    time.sleep(3.0)
    command.send_signal(signal.SIGINT)
    _, errors = command.communicate(timeout=60)
    assert command.returncode == 130 and "interrupted" in errors
    assert frames_of(tmp_path / "teleop.mcap")


def child_of(process, name):
    return int(subprocess.run(["pgrep", "-P", str(process.pid), name], capture_output=True,
                              text=True, check=True).stdout.split()[0])


class Terminal:
    """kelpie teleop on a terminal of its own; all that it draws is in `seen`."""

    def __init__(self, out, *words, columns=80, rows=24, kind="xterm-256color", programs=BIN):
        self.leader, self.follower = pty.openpty()
        size = struct.pack("HHHH", rows, columns, 0, 0)
        fcntl.ioctl(self.follower, termios.TIOCSWINSZ, size)
        self.before = termios.tcgetattr(self.follower)
        self.seen = b""
        self.process = subprocess.Popen(
            [programs / "kelpie", "teleop", "--out", out, *words], cwd=ROOT, stdin=self.follower,
            stdout=self.follower, stderr=subprocess.PIPE, start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
            env=dict(os.environ, TERM=kind, TMPDIR=str(out)))

    def read(self, seconds, until=None):
        """Reads on for so long, or until what was drawn since holds `until`."""
        end = time.monotonic() + seconds
        start = len(self.seen)
        while time.monotonic() < end:
            if select.select([self.leader], [], [], 0.1)[0]:
                self.seen += os.read(self.leader, 1 << 16)
            if until is not None and re.search(until, self.seen[start:]):
                return True
        return until is None

    def type(self, keys):
        os.write(self.leader, keys)

    def end(self):
        """Exit code; asserts that the terminal is as it was."""
        while self.process.poll() is None:
            self.read(0.1)
        self.read(0.2)
        self.errors = self.process.stderr.read().decode()
        assert termios.tcgetattr(self.follower) == self.before
        if b"\033[?1049h" in self.seen:
            assert b"\033[?25h\033[?1049l" in self.seen.rsplit(BLOCK, 1)[-1]
        os.close(self.leader)
        os.close(self.follower)
        return self.process.returncode


def test_somebody_drives_at_a_terminal_and_sees_what_the_robot_sees(tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    terminal.type(b"w\033[A\033[D1")
    assert terminal.read(10, rb"ahead 10 cm/s  turn left 20 deg/s")
    assert terminal.read(5, rb"  kick \d")
    terminal.type(b"x")
    assert terminal.end() == 0, terminal.errors
    rows = re.findall(rb"\033\[(\d+);1H\033\[38;2;\d+;\d+;\d+m\033\[48;2;\d+;\d+;\d+m" + BLOCK,
                      terminal.seen)
    assert {int(row) for row in rows} == set(range(1, 18))  # 24 rows, six of them text
    motions = [frame["command"]["motion"] for frame in frames_of(tmp_path / "teleop.mcap")]
    assert KICK_FORWARD in motions
    assert b"teleop.mcap: log" in terminal.seen.rsplit(b"\033[?1049l", 1)[-1]


def test_time_goes_no_faster_than_a_clock_while_somebody_drives(tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    begun = time.monotonic()
    terminal.read(2.0)
    terminal.type(b"x")
    assert terminal.end() == 0
    driven = float(re.search(rb"drove ([\d.]+) simulated", terminal.seen)[1])
    assert driven < time.monotonic() - begun + 3.0


@pytest.mark.parametrize("stop", ["ctrl-c", "terminate", "hang up"])
def test_the_terminal_is_as_before_after_an_interrupt(stop, tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    if stop == "ctrl-c":
        terminal.type(b"\003")
    else:
        terminal.process.send_signal(signal.SIGTERM if stop == "terminate" else signal.SIGHUP)
    assert terminal.end() == 0, terminal.errors
    assert [p.name for p in tmp_path.iterdir()] == ["teleop.mcap"]
    assert frames_of(tmp_path / "teleop.mcap")


@pytest.mark.parametrize("who", ["kelpie-agent", "kelpie-world"])
def test_the_terminal_is_as_before_when_a_process_dies(who, tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    os.kill(child_of(terminal.process, who), signal.SIGKILL)
    assert terminal.end() == 3
    assert "died (signal 9)" in terminal.errors.splitlines()[-1]


def test_keys_that_would_stop_or_kill_do_nothing(tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    terminal.type(b"\032\034\023w")  # Ctrl-Z, Ctrl-\ and Ctrl-S
    assert terminal.read(10, rb"ahead 5 cm/s")
    terminal.type(b"x")
    assert terminal.end() == 0


def test_a_dumb_terminal_gets_one_line_without_escapes(tmp_path):
    terminal = Terminal(tmp_path, kind="dumb")
    assert terminal.read(20, rb"\r +[\d.]+ s  stands")
    terminal.type(b"x")
    assert terminal.end() == 0
    assert terminal.errors == "kelpie: no picture: TERM is dumb\n"
    assert b"\033" not in terminal.seen


@pytest.mark.parametrize("columns, rows", [(20, 24), (80, 6), (10, 2), (1, 1)])
def test_a_small_terminal_goes_without_the_picture(columns, rows, tmp_path):
    terminal = Terminal(tmp_path, columns=columns, rows=rows)
    assert terminal.read(20, rb"\033\[1;1H")
    terminal.read(2.0)
    terminal.type(b"x")
    assert terminal.end() == 0
    assert BLOCK not in terminal.seen
    rows_drawn = {int(row) for row in re.findall(rb"\033\[(\d+);1H", terminal.seen)}
    assert max(rows_drawn) <= rows


def test_the_picture_follows_the_size_of_the_terminal(tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    fcntl.ioctl(terminal.follower, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 120, 0, 0))
    assert terminal.read(5, rb"\033\[33;1H\033\[38;2")
    terminal.type(b"x")
    assert terminal.end() == 0


def with_agent(folder, script):
    """The programs once more, in a folder in which that shell script is the agent."""
    folder.mkdir()
    shutil.copy(BIN / "kelpie", folder)
    shutil.copy(BIN / "kelpie-world", folder)
    (folder / "kelpie-agent").write_text(f"#!/bin/sh\n{script}\n")
    (folder / "kelpie-agent").chmod(0o755)
    return folder


@pytest.fixture(name="late")
def programs_whose_agent_starts_two_seconds_late(tmp_path):
    return with_agent(tmp_path / "bin", f'sleep 2\nexec "{BIN}/kelpie-agent" "$@"')


def test_an_agent_that_starts_late_is_waited_for(late, tmp_path):
    terminal = Terminal(tmp_path / "out", programs=late)
    assert terminal.read(20, rb" s  stands")
    terminal.type(b"w")
    assert terminal.read(10, rb"ahead 5 cm/s")
    terminal.type(b"x")
    assert terminal.end() == 0, terminal.errors
    assert frames_of(tmp_path / "out" / "teleop.mcap")


def test_keys_typed_before_a_late_agent_comes_are_its_first(late, tmp_path):
    terminal = Terminal(tmp_path / "out", programs=late)
    assert terminal.read(10, rb"\033\[\?1049h")
    terminal.type(b"ww")
    assert terminal.read(20, rb"ahead 10 cm/s")
    terminal.type(b"x")
    assert terminal.end() == 0, terminal.errors


def test_a_driver_who_quits_before_the_agent_came_is_informed(tmp_path):
    programs = with_agent(tmp_path / "bin", "exec sleep 60")
    terminal = Terminal(tmp_path / "out", programs=programs)
    assert terminal.read(10, rb"\033\[\?1049h")
    terminal.type(b"x")
    assert terminal.end() == 3
    assert "the agent had not begun to play and was killed; last: before" in terminal.errors


def test_an_agent_that_was_stopped_is_not_taken_for_a_script_in_a_long_call(tmp_path):
    terminal = Terminal(tmp_path)
    assert terminal.read(20, rb" s  stands")
    os.kill(agent_of(terminal.process), signal.SIGSTOP)
    terminal.type(b"x")
    assert terminal.end() == 3
    assert "the agent was stopped by a signal, and was killed" in terminal.errors


@pytest.mark.parametrize("does, blamed", [("while :; do :; done", True), ("exec sleep 60", False)])
def test_a_script_is_blamed_for_an_agent_that_computes_on_and_on(does, blamed, tmp_path):
    programs = with_agent(tmp_path / "bin", f"echo status playing\n{does}")
    play = subprocess.Popen([programs / "kelpie", "play", "--out", tmp_path / "out", "--no-film"],
                            cwd=ROOT, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    time.sleep(2.0)  # the world and its way to end are there, and the agent has said its line
    os.kill(child_of(play, "kelpie-world"), signal.SIGTERM)
    _, errors = play.communicate(timeout=60)
    assert play.returncode == 3
    assert "the agent did not answer and was killed" in errors
    assert ("a script in a long call?" in errors) == blamed
