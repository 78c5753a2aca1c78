# SPDX-License-Identifier: Apache-2.0
"""A match that is killed, stopped, or runs out of disk loses at most its last second, and harms
nothing else in its folder. The watched robot's log goes out record by record, so that its last
stamp says when the match was killed; the world's and the other robots' go out in chunks."""

import os
import random
import re
import shutil
import signal
import subprocess
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie

PLAY = ("play", "--robots", "2v2", "--minutes", "5", "--fast", "--logs", "all", "--no-film")
ROBOTS = ("match", "red-1", "blue-1", "blue-2")  # of these red 2 is watched
MOMENTS = 30


def start(out, *words):
    return subprocess.Popen([BIN / "kelpie", *PLAY, "--out", out, *words], cwd=ROOT, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            start_new_session=True)


def wait_for_play(out, seconds=60):
    """Until the log holds what it begins with, 270 KB, and more than half a second of play."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if (out / "playing/match.mcap").is_file() and \
                (out / "playing/match.mcap").stat().st_size > 330_000:
            return
        time.sleep(0.02)
    raise AssertionError("the match did not begin")


def spans(log):
    """{topic: last second} of a log."""
    lines = kelpie("info", log).stdout.splitlines()
    return {words[0]: float(words[-1]) for words in map(str.split, lines) if words[0][0] == "/"}


def put_precious(out):
    """What else a user keeps there, and an earlier match."""
    out.mkdir(exist_ok=True)
    for name in ("notes.txt", "match.mcap", "my-match.mcap"):
        (out / name).write_text(f"precious {name}")


def expect_precious(out):
    assert (out / "notes.txt").read_text() == "precious notes.txt"
    assert (out / "my-match.mcap").read_text() == "precious my-match.mcap"
    kept = [path for path in (out / "match.mcap", out / "earlier/1/match.mcap") if path.exists()
            and path.read_bytes() == b"precious match.mcap"]
    assert len(kept) == 1


def expect_all_but_a_second(folder):
    ends = {name: spans(folder / f"{name}.mcap") for name in ROBOTS}
    killed = ends["match"]["/frame/output"]
    assert killed > 0.3
    for name, topics in ends.items():
        for topic in ("/frame/output", "/truth"):
            assert topics.get(topic, 0.0) > killed - 1.0, f"{name} {topic} ends before {killed} s"


def end_group(match, number):
    os.killpg(match.pid, number)


def end_alone(match, number):
    os.kill(match.pid, number)


ENDS = [(end_alone, signal.SIGKILL), (end_group, signal.SIGKILL), (end_group, signal.SIGTERM),
        (end_alone, signal.SIGTERM), (end_alone, signal.SIGINT)]


@pytest.mark.parametrize("moment", range(MOMENTS))
def test_a_match_that_is_killed_at_any_moment_loses_at_most_a_second(tmp_path, moment):
    chance = random.Random(530 + moment)
    out = tmp_path / "out"
    put_precious(out)
    end, number = ENDS[moment % len(ENDS)]
    match = start(out)
    wait_for_play(out)
    time.sleep(chance.uniform(0.0, 1.5))
    end(match, number)
    match.communicate(timeout=60)
    if (out / "playing").exists():  # nobody was left to join the logs
        (out / "match.mcap").rename(out / "aside.mcap")
        recovered = kelpie("recover", out)
        assert recovered.returncode == 0, recovered.stderr
        expect_all_but_a_second(out)
        (out / "match.mcap").unlink()
        (out / "aside.mcap").rename(out / "match.mcap")
    else:
        assert number != signal.SIGKILL
        expect_all_but_a_second(out)
    expect_precious(out)


def test_the_next_match_moves_what_a_killed_one_left_and_says_where(tmp_path):
    out = tmp_path / "out"
    match = start(out)
    wait_for_play(out)
    end_alone(match, signal.SIGKILL)
    match.communicate(timeout=60)
    result = kelpie("play", "--fast", "--seconds", "2", "--no-film", "--out", out)
    assert result.returncode == 0, result.stderr
    assert "a match was killed there; its logs are in" in result.stderr
    recovered = kelpie("recover", out / "earlier/1")
    assert recovered.returncode == 0, recovered.stderr
    expect_all_but_a_second(out / "earlier/1")
    assert kelpie("recover", out / "earlier/1").returncode == 2  # nothing is left to join


def test_two_matches_in_one_folder_go_to_two_folders(tmp_path):
    out = tmp_path / "out"
    match = start(out)
    wait_for_play(out)
    result = kelpie("play", "--fast", "--seconds", "2", "--no-film", "--out", out)
    assert result.returncode == 0, result.stderr
    assert f"{out}: a match is being played there; this one goes to {out}-2" in result.stderr
    assert (tmp_path / "out-2/match.mcap").exists() and match.poll() is None
    refused = kelpie("recover", out)
    assert refused.returncode == 2 and "is being played there" in complaint(refused)
    end_group(match, signal.SIGKILL)
    match.communicate(timeout=60)
    assert (out / "playing/match.mcap").exists()


def test_earlier_matches_are_kept_and_of_the_default_folder_the_last_five(tmp_path):
    for seed in range(8):
        result = subprocess.run([BIN / "kelpie", "play", "--fast", "--seconds", "1", "--no-film",
                                 "--seed", str(seed)], cwd=tmp_path, capture_output=True,
                                text=True, timeout=60, check=False)
        assert result.returncode == 0, result.stderr
    kept = sorted(path.name for path in (tmp_path / "out/earlier").iterdir())
    assert kept == ["3", "4", "5", "6", "7"]
    assert (tmp_path / "out/match.mcap").exists()


def test_a_folder_that_is_removed_ends_in_one_line(tmp_path):
    out = tmp_path / "out"
    match = start(out)
    wait_for_play(out)
    shutil.rmtree(out)
    end_alone(match, signal.SIGINT)
    _, said = match.communicate(timeout=60)
    assert match.returncode == 3
    assert re.search(r"^kelpie: .*/out/playing: its logs are gone$", said, re.M), said
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 4 MB."""
    place = tmp_path / "disk"
    place.mkdir()
    if os.geteuid() != 0 or subprocess.run(
            ["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", place], check=False,
            capture_output=True).returncode != 0:
        pytest.skip("no small file system can be mounted here")
    yield place
    subprocess.run(["umount", "-l", place], check=False)


def test_a_full_disk_ends_the_logs_and_the_match_goes_on(small_disk, tmp_path):
    result = kelpie("play", "--fast", "--seconds", "5", "--goals", "9", "--no-film", "--out",
                    small_disk / "out")
    assert result.returncode == 3
    line = complaint(result)
    ends = re.search(r"playing/match\.mcap: byte (\d+): cannot write the log: No space left on "
                     r"device; the log ends at ([\d.]+) s", line)
    assert ends and "kelpie recover" in line
    assert "5.0 simulated seconds" in result.stdout
    moved = tmp_path / "moved"
    shutil.copytree(small_disk / "out", moved)  # where there is room
    recovered = kelpie("recover", moved)
    assert recovered.returncode == 0, recovered.stderr
    assert spans(moved / "match.mcap")["/frame/output"] == pytest.approx(float(ends[2]), abs=0.2)


def test_a_full_disk_ends_the_match_if_that_is_asked_for(small_disk):
    result = kelpie("play", "--fast", "--seconds", "60", "--goals", "9", "--no-film",
                    "--end-with-log", "--out", small_disk / "out")
    assert result.returncode == 3 and "the log ends at" in complaint(result)
    seconds = re.search(r"([\d.]+) simulated seconds", result.stdout)
    assert seconds is None or float(seconds[1]) < 30.0
