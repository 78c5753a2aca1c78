# SPDX-License-Identifier: Apache-2.0
"""`kelpie film`: its views, its pictures, and what it says of logs that it cannot show."""

import os
import shutil
import signal
import struct
import subprocess

import pytest
from conftest import BIN, complaint, kelpie


@pytest.fixture(scope="module")
def teams(tmp_path_factory):
    """A second of two robots a side, with the logs of all."""
    out = tmp_path_factory.mktemp("teams")
    result = kelpie("play", "--robots", "2v2", "--fast", "--seconds", "1", "--logs", "all",
                    "--no-film", "--seed", "5", "--out", out)
    assert (out / "red-1.mcap").exists(), result.stderr
    return out


def size_of(picture):
    head = picture.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", head[16:24])


@pytest.mark.parametrize("view", ["broadcast", "robot", "split"])
def test_every_view_makes_a_film(match, tmp_path, view):
    result = kelpie("film", match, tmp_path / "f.mp4", "--view", view)
    assert result.returncode == 0, result.stderr
    assert b"ftyp" in (tmp_path / "f.mp4").read_bytes()[:16]
    assert [path.name for path in tmp_path.iterdir()] == ["f.mp4"]


def test_a_view_that_is_none_is_refused(match, tmp_path):
    result = kelpie("film", match, tmp_path / "f.mp4", "--view", "moon")
    assert result.returncode == 2 and "broadcast" in complaint(result)
    assert list(tmp_path.iterdir()) == []


def test_a_film_without_a_name_is_refused(match):
    result = kelpie("film", match)
    assert result.returncode == 2 and "OUT is required" in complaint(result)


def test_an_out_that_ends_otherwise_is_refused(match, tmp_path):
    result = kelpie("film", match, tmp_path / "f.gif")
    assert result.returncode == 2 and ".mp4" in complaint(result)


def test_a_log_that_is_missing_is_named(match, tmp_path):
    for logs in ([tmp_path / "no.mcap"], [match, tmp_path / "no.mcap"]):
        result = kelpie("film", *logs, tmp_path / "f.mp4")
        assert result.returncode == 2 and "no.mcap" in complaint(result)
    assert list(tmp_path.iterdir()) == []


def test_two_logs_of_one_robot_are_refused(match, tmp_path):
    shutil.copy(match, tmp_path / "again.mcap")
    result = kelpie("film", match, tmp_path / "again.mcap", tmp_path / "f.mp4")
    assert result.returncode == 2 and "again.mcap: is of a robot" in complaint(result)


def test_what_a_cut_log_still_holds_is_shown_and_the_cut_is_told(match, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(match.read_bytes()[:-200000])
    result = kelpie("film", cut, tmp_path / "f.mp4")
    assert result.returncode == 2 and "cut off" in complaint(result)
    assert complaint(result).count("cut off") == 1
    assert (tmp_path / "f.mp4").stat().st_size > 1000


def test_an_interrupted_film_leaves_nothing(match, tmp_path):
    # Whoever runs the tests in the background has its children ignore it.
    film = subprocess.Popen([BIN / "kelpie", "film", match, tmp_path / "f.mp4"],
                            stderr=subprocess.PIPE, text=True,
                            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    film.send_signal(signal.SIGINT)
    _, errors = film.communicate(timeout=30)
    assert film.returncode in (130, -signal.SIGINT), errors
    assert list(tmp_path.iterdir()) == []


def test_the_logs_beside_one_are_of_the_same_match(teams, tmp_path):
    """The split view finds red-1.mcap and the others; without them their tiles say so."""
    alone = tmp_path / "alone"
    alone.mkdir()
    shutil.copy(teams / "match.mcap", alone)
    pictures = []
    for log in (teams / "match.mcap", alone / "match.mcap"):
        out = tmp_path / f"{len(pictures)}.png"
        result = kelpie("film", log, out, "--view", "split", "--at", "1")
        assert result.returncode == 0, result.stderr
        pictures.append(out.read_bytes())
    assert size_of(tmp_path / "0.png") == (1280, 720)
    assert pictures[0] != pictures[1]


def test_the_picture_of_a_match_is_drawn_again_from_its_log(match, tmp_path):
    assert kelpie("film", match, tmp_path / "m.png").returncode == 0
    assert (tmp_path / "m.png").read_bytes() == (match.parent / "match.png").read_bytes()
    assert kelpie("film", match, tmp_path / "s.png", "--small").returncode == 0
    assert (tmp_path / "s.png").stat().st_size < (tmp_path / "m.png").stat().st_size / 2


def test_a_time_behind_the_end_is_told(match, tmp_path):
    result = kelpie("film", match, tmp_path / "f.png", "--at", "99")
    assert result.returncode == 2 and "the log ends before 99.0 s" in complaint(result)


def test_the_log_knows_which_match_it_is(match, teams):
    said = kelpie("info", match).stdout
    assert "match.seed = 4" in said and "match.red = kelpie" in said
    assert "match.blue" not in said  # an empty goal
    assert "match.blue = kelpie" in kelpie("info", teams / "match.mcap").stdout


def test_a_match_is_not_lost_where_no_font_is(tmp_path):
    (tmp_path / "fonts.conf").write_text("<fontconfig></fontconfig>\n")
    env = dict(os.environ, FONTCONFIG_FILE=str(tmp_path / "fonts.conf"))
    result = kelpie("play", "--fast", "--seconds", "1", "--no-film", "--out", tmp_path / "out",
                    env=env)
    assert result.returncode == 3
    assert "no font to write with" in complaint(result)
    assert (tmp_path / "out/match.mcap").exists() and "no goal in 1 s" in result.stdout
