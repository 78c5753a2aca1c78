# SPDX-License-Identifier: Apache-2.0
"""tools/soak: long play with killed agents, a bad radio and edited behaviours is judged right."""

import runpy
import subprocess

from conftest import ROOT

SOAK = runpy.run_path(str(ROOT / "tools/soak"))


def soak(out, *words, programs=None):
    environment = {"KELPIE_BIN": str(programs)} if programs else None
    return subprocess.run([ROOT / "tools/soak", "--out", out, *words], env=environment,
                          capture_output=True, text=True, timeout=200)


def wrongs(memory, code=0, lines=(), kills=0):
    reported = SOAK["Messages"]()
    for line in lines:
        reported.line(line)
    kept = SOAK["Memory"]()
    kept.samples = memory
    return list(SOAK["wrongs_of"](code, False, kept, reported, {"kills": kills}))


def minutes_of(megabytes, minutes=60):
    """A sample a second of what a process holds after so many hours."""
    return {"red 2": [(second, megabytes(second / 3600)) for second in range(60 * minutes)]}


def test_memory_that_grows_is_reported_and_a_start_is_no_growth():
    assert wrongs(minutes_of(lambda hour: 30 + 6 * hour)) == [
        "red 2 grows by 6.0 MB an hour: 30.6 MB, then 35.5 MB"]
    assert wrongs(minutes_of(lambda hour: 20 if hour < 0.01 else 30)) == []
    assert wrongs(minutes_of(lambda hour: 30 + 6 * hour, minutes=0)) == []  # died at once


def test_a_line_that_nothing_explains_is_reported():
    assert wrongs({}, lines=["playing: seed 3", "behaviour: main.py: loaded again"]) == []
    assert wrongs({}, lines=["the mate red 1: behaviour: a.py:3: MemoryError"]) == [
        "unexplained: the mate red 1: behaviour: a.py:3: MemoryError"]


def test_a_killed_agent_comes_back_or_is_reported_and_only_the_last_may_be_late():
    killed = "the mate red 1 died (signal 9); it is started again"
    back = "agent red 1 is there again; connection closed by the agent"
    assert wrongs({}, lines=[killed, back, killed], kills=2) == []
    assert wrongs({}, lines=[killed, back, killed, killed], kills=3) == [
        "3 agents were killed, 3 reported, 1 came back"]
    assert wrongs({}, lines=[killed, back]) == ["0 agents were killed, 1 reported, 1 came back"]


def test_half_a_minute_of_it_is_well(tmp_path):
    result = soak(tmp_path / "out", "--hours", "0.006", "--seed", "17")
    assert result.returncode == 0, result.stdout + result.stderr
    assert "'kills': 1" in result.stdout and "'came back': 1" in result.stdout


def test_a_match_that_ends_in_another_way_fails(tmp_path):
    (tmp_path / "kelpie").write_text("#!/bin/sh\necho 'the world died (signal 11)' >&2\nexit 3\n")
    (tmp_path / "kelpie").chmod(0o755)
    result = soak(tmp_path / "out", "--hours", "0.0001", programs=tmp_path)
    assert result.returncode == 1
    assert "match 1: kelpie play ended with exit code 3" in result.stderr
    assert "match 1: unexplained: the world died (signal 11)" in result.stderr


def test_what_it_cannot_do_is_one_line(tmp_path):
    for words, line in ((("--hours", "0"), "--hours: more than 0, at most 1000"),):
        result = soak(tmp_path / "out", *words)
        assert result.returncode == 2 and result.stderr == f"tools/soak: {line}\n"
    result = soak(tmp_path, "--hours", "1")
    assert result.returncode == 2 and "is there already" in result.stderr
    result = soak(tmp_path / "out", programs=tmp_path)
    assert result.returncode == 2 and "is not built" in result.stderr
