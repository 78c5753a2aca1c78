# SPDX-License-Identifier: Apache-2.0
"""Matches start the agents of a team from elsewhere confined: the kernel says so of the process
that plays (docs/behaviours.md). What such a process can do no more is told by tests/session."""

import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from conftest import BIN, ROOT

STANDS = "import kelpie\n\n\ndef decide(world):\n    return kelpie.Command()\n"
OWN = "teams/runner"  # Kelpie's own that has scripts
WAYS = {
    "play": ("play", "--red", OWN, "--robots", "1v1", "--seconds", "600", "--no-film", "--blue"),
    "league of percepts": ("league", OWN, "--percepts", "--matches", "2", "--minutes", "60",
                           "--robots", "1v1", "--workers", "1"),
}


def filters(pid):
    """The lines of a process's seccomp: its mode, and how many filters it has."""
    lines = Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines()
    return [line for line in lines if line.startswith("Seccomp")]


def strangers(match, team):
    """The processes of a running match that are told of the team's folder."""
    for task in Path(f"/proc/{match.pid}/task").iterdir():
        for pid in (task / "children").read_text(encoding="ascii").split():
            words = Path(f"/proc/{pid}/cmdline").read_text(encoding="utf-8").split("\0")
            if any(word == str(team) or word.endswith(f"={team}") for word in words):
                yield pid


def confined(match, team):
    """Whether a stranger has a filter more than who asks, which may run in a container."""
    try:
        return any("Seccomp:\t2" in filters(pid) and filters(pid) != filters("self")
                   for pid in strangers(match, team))
    except (FileNotFoundError, ProcessLookupError):  # it has just ended
        return False


@pytest.mark.parametrize("way", WAYS)
def test_a_team_from_elsewhere_plays_confined(way, tmp_path):
    team = tmp_path / "foxes"
    team.mkdir()
    (team / "main.py").write_text(STANDS)
    match = subprocess.Popen([BIN / "kelpie", *WAYS[way], team, "--out", tmp_path / "out"],
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT,
                             env=dict(os.environ, TMPDIR=str(tmp_path)))
    end = time.monotonic() + 30
    seen = False
    while not seen and match.poll() is None and time.monotonic() < end:
        seen = confined(match, team)
        time.sleep(0.05)
    match.send_signal(signal.SIGINT)
    _, errors = match.communicate(timeout=60)
    assert seen, errors
