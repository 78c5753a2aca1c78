# SPDX-License-Identifier: Apache-2.0
"""`kelpie motion`: what it says of a motion, film and picture, and files with mistakes."""

import shutil

import pytest
from conftest import ROOT, complaint, kelpie

MOTIONS = ROOT / "actuator/data/motions"
FRAME = "[[frame]]\nticks = 9\nfront = [0, 10, 20]\nhind = [0, 10, 20]\n"


def test_a_kick_says_where_the_ball_went_and_that_it_stands():
    result = kelpie("motion", "upenn_left")
    assert result.returncode == 0, result.stderr
    assert "2 key frames" in result.stdout and "stands at the end" in result.stdout
    assert "12.0 cm ahead" in result.stdout and "deg to the left" in result.stdout
    assert "fastest joint: " in result.stdout


def test_a_get_up_begins_lying():
    assert "it lay and stands at the end" in kelpie("motion", "get_up_front").stdout


def test_a_block_says_what_it_covers():
    result = kelpie("motion", "block", "--model", "5")
    assert "varied robot 5" in result.stdout and "at the ball's height" in result.stdout


def test_a_path_is_played_as_the_motion_that_its_name_says(tmp_path):
    copy = tmp_path / "upenn_left.toml"
    shutil.copy(MOTIONS / "upenn_left.toml", copy)
    assert kelpie("motion", copy).stdout == kelpie("motion", "upenn_left").stdout


def test_a_file_of_another_name_is_a_kick_where_it_says_so_or_as_an_option_says(tmp_path):
    free, copy = tmp_path / "free.toml", tmp_path / "mine.toml"
    shutil.copy(MOTIONS / "upenn_left.toml", free)
    shutil.copy(MOTIONS / "hard_forward.toml", copy)
    assert "lay 12.0 cm ahead and 6.0 cm to the right" in kelpie("motion", free).stdout
    held = kelpie("motion", copy, "--as", "hard_forward")
    assert held.stdout.splitlines()[1:] == kelpie("motion", "hard_forward").stdout.splitlines()[1:]


def test_a_motion_that_falls_ends_with_1(tmp_path):
    file = tmp_path / "fall.toml"
    file.write_text("[[frame]]\nticks = 60\nleft_front = [100, 0, 30]\n"
                    "left_hind = [-100, 0, 30]\nright_front = [0, -10, 0]\n"
                    "right_hind = [0, -10, 0]\n"
                    "[[frame]]\nticks = 60\nleft_front = [0, 88, 30]\n"
                    "left_hind = [0, 88, 30]\nright_front = [0, 88, -20]\n"
                    "right_hind = [0, 88, -20]\n")
    result = kelpie("motion", file)
    assert result.returncode == 1 and "robot: it fell" in result.stdout


def test_picture_and_film_are_written(tmp_path):
    picture, film = tmp_path / "sit.png", tmp_path / "sit.mp4"
    assert kelpie("motion", "sit", "--picture", picture, "--film", film).returncode == 0
    assert picture.read_bytes()[:4] == b"\x89PNG"
    assert b"ftyp" in film.read_bytes()[:16]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["sit.mp4", "sit.png"]


@pytest.mark.parametrize("text, reported", [
    ("", "has no [[frame]]"),
    (FRAME + "speed = 3\n", "speed: there is no such key"),
    (FRAME.replace("[0, 10, 20]", "[0, 10]"), ":3: front: wants 3 angles"),
    ("slew = [\n", "mine.toml:"),
])
def test_a_file_with_a_mistake_is_one_line_and_2(tmp_path, text, reported):
    file = tmp_path / "mine.toml"
    file.write_text(text)
    result = kelpie("motion", file)
    assert result.returncode == 2 and result.stdout == ""
    assert reported in complaint(result) and result.stderr.count("\n") == 1


@pytest.mark.parametrize("words, reported", [
    (["dance"], "dance: no such motion; there are stand, sit, "),
    (["nowhere.toml"], "nowhere.toml"),
    (["sit", "--as", "dance"], "dance: no such motion"),
    (["sit", "--picture", "/nowhere/at/all.png"], "cannot be written"),
    (["sit", "--film", "/nowhere/at/all.mp4"], "cannot be written"),
    (["sit", "--seed", "x"], "--seed: x is not a number"),
])
def test_what_cannot_be_played_is_one_line_and_2(words, reported):
    result = kelpie("motion", *words)
    assert result.returncode == 2
    assert reported in complaint(result) and result.stderr.count("\n") == 1


def test_the_same_seed_and_model_say_the_same():
    words = ("motion", "cheer", "--model", "7", "--seed", "3")
    assert kelpie(*words).stdout == kelpie(*words).stdout


def test_a_film_ends_with_an_error_that_names_it(tmp_path):
    result = kelpie("motion", "sit", "--film", tmp_path / "sit.nothing")
    assert result.returncode == 2 and "sit.nothing" in result.stderr
    assert not list(tmp_path.iterdir())


def test_only_a_kick_of_a_held_ball_is_searched_for_after_a_turn(tmp_path):
    result = kelpie("calibrate", "motion", "upenn_left", "--turned", "--out", tmp_path / "u.toml")
    assert result.returncode == 2
    assert "--turned: upenn_left is no kick of a held ball" in complaint(result)
    assert not (tmp_path / "u.toml").exists()
