# SPDX-License-Identifier: Apache-2.0
"""Runs the built programs as a user would. KELPIE_BIN: their folder, default build/host/bin."""

import os
import pty
import select
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("KELPIE_BIN", ROOT / "build/host/bin"))
HEADER = ("t_s,neck_tilt_deg,head_pan_deg,head_nod_deg,body_tilt_deg,shoulder_height_mm,"
          "odo_forward_cm,odo_left_cm,odo_turn_deg")
PLANE = 208 * 160


def kelpie(*words, timeout=240, env=None):
    return subprocess.run([BIN / "kelpie", *map(str, words)], capture_output=True, text=True,
                          timeout=timeout, check=False, cwd=ROOT, env=env)


def agent(*words):
    return subprocess.run([BIN / "kelpie-agent", *map(str, words)], capture_output=True, text=True,
                          timeout=120, check=False)


def complaint(result):
    """The one line that a user gets; fails when there are more."""
    lines = [line for line in result.stderr.splitlines() if line.startswith("kelpie: ")]
    assert len(lines) == 1, result.stderr
    return lines[0]


def make_recording(folder, frames):
    """Frames as bytes (three planes) or names of files, with plain sensor rows."""
    (folder / "frames").mkdir(parents=True)
    rows = [HEADER]
    for i, planes in enumerate(frames):
        (folder / "frames" / f"{i:06d}.yuv").write_bytes(planes)
        rows.append(f"{i / 30:.4f},-20,0,0,14.25,100,0,0,0")
    (folder / "sensors.csv").write_text("\n".join(rows) + "\n")
    return folder


@pytest.fixture(scope="session")
def match(tmp_path_factory):
    """Three simulated seconds of play; the log is the same for every test."""
    out = tmp_path_factory.mktemp("match")
    result = kelpie("play", "--seconds", "3", "--seed", "4", "--out", out, "--no-film")
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


def on_a_terminal(*words):
    """What a command draws on standard error when that is a terminal, and its exit code."""
    leader, follower = pty.openpty()
    command = subprocess.Popen([BIN / "kelpie", *words], stderr=follower,
                               stdout=subprocess.DEVNULL)
    os.close(follower)
    seen = b""
    while select.select([leader], [], [], 30)[0]:
        try:
            seen += os.read(leader, 4096)
        except OSError:  # the command has closed its end
            break
    os.close(leader)
    return seen, command.wait(timeout=30)
