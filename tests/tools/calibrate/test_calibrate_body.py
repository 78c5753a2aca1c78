# SPDX-License-Identifier: Apache-2.0
"""kelpie calibrate body: a robot's lens, neck and lean from a log, or its lens from sizes."""

import tomllib
from pathlib import Path

import pytest
from conftest import ROOT, complaint, kelpie

SIZES = Path(ROOT).parent / "shared" / "data" / "distance"
LOOKING = ROOT / "tools" / "calibrate" / "looking"


@pytest.fixture(scope="module")
def stand(tmp_path_factory):
    """A robot with a body unlike its parameters that stands and looks round."""
    out = tmp_path_factory.mktemp("stand")
    result = kelpie("play", "--fast", "--pycode", LOOKING, "--seconds", "14", "--seed", "3",
                    "--randomise", "5", "--randomise-only", "lens", "body", "--images", "all",
                    "--no-film", "--out", out)
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


def test_a_log_gives_a_file_of_parameters_that_play_takes_and_a_picture(stand, tmp_path):
    params, picture = tmp_path / "robot.toml", tmp_path / "residuals.png"
    result = kelpie("calibrate", "body", stand, "--out", params, "--picture", picture)
    assert result.returncode == 0, result.stderr
    assert "lens.focalLength" in result.stdout and "line points" in result.stdout
    assert "stops of the head" in result.stdout and result.stderr == ""
    assert picture.read_bytes()[:4] == b"\x89PNG"
    text = params.read_text()
    assert "[body]\n" in text and "neckTiltOffset = \"" in text and "# sd 0." in text
    assert "[vision.beacon]\nedgeBias = \"" in text
    played = kelpie("play", "--seconds", "1", "--no-film", "--params", params, "--out",
                    tmp_path / "out")
    assert played.returncode == 0 and "no goal in 1 s" in played.stdout, played.stderr


def test_without_an_output_it_only_tells(stand):
    result = kelpie("calibrate", "body", stand)
    assert result.returncode == 0 and ".toml" not in result.stdout


def test_a_robot_that_plays_is_refused_in_one_line(match, tmp_path):
    out = tmp_path / "robot.toml"
    result = kelpie("calibrate", "body", match, "--out", out)
    assert result.returncode == 2 and not out.exists()
    assert "match.mcap: the robot's longest stand is" in complaint(result)


def test_what_is_no_log_and_the_input_itself_are_refused(stand, tmp_path):
    result = kelpie("calibrate", "body", tmp_path / "none.mcap")
    assert result.returncode == 2 and "none.mcap" in complaint(result)
    result = kelpie("calibrate", "body", stand, "--out", stand)
    assert result.returncode == 2 and "is the input itself" in complaint(result)
    both = tmp_path / "both.png"
    result = kelpie("calibrate", "body", stand, "--out", both, "--picture", both)
    assert result.returncode == 2 and "--out and --picture" in complaint(result)


@pytest.mark.skipif(not SIZES.is_dir(), reason="../shared/data is not there: no measured sizes")
def test_measured_sizes_tell_the_focal_length_of_2005(tmp_path):
    params = tmp_path / "lens.toml"
    result = kelpie("calibrate", "body", SIZES, "--out", params)
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    focal = [line for line in lines if line.startswith("lens.focalLength")][0]
    value, sd = float(focal.split()[1]), float(focal.split()[3])
    assert abs(value - 201.5) < sd < 4.0
    written = tomllib.loads(params.read_text())
    assert written["body"]["lens"]["focalLength"].startswith("20")
    assert set(written["vision"]) == {"ball", "beacon", "goal"}
    beacon = [line for line in lines if line.startswith("beacon")][0]
    assert f"edge {float(written['vision']['beacon']['edgeBias'][:-2]):5.2f} px" in beacon
    assert kelpie("play", "--seconds", "1", "--no-film", "--params", params, "--out",
                  tmp_path / "out").returncode == 0
    result = kelpie("calibrate", "body", SIZES, "--picture", tmp_path / "p.png")
    assert result.returncode == 2 and "--picture: only for a log" in complaint(result)


def test_a_folder_without_sizes_is_one_line(tmp_path):
    result = kelpie("calibrate", "body", tmp_path)
    assert result.returncode == 2 and "ball_radius.csv: cannot be opened" in complaint(result)


def test_a_wrong_size_is_named_by_file_and_line_and_an_empty_line_is_none(tmp_path):
    for name, size in (("ball_radius.csv", 20), ("beacon_height_lab.csv", 60),
                       ("goal_height.csv", 60)):
        rows = "".join(f"a,{size - i},{100 + 10 * i},0\n" for i in range(8))
        (tmp_path / name).write_text("series,pixels,distance,excluded\n" + rows + "\n")
    ball = tmp_path / "ball_radius.csv"
    text = ball.read_text()
    for bad in ("a,nan,12,0", "a,-3,100,0", "a,3,0,0", "a,abc,1,0"):
        ball.write_text(text + bad + "\n")
        result = kelpie("calibrate", "body", tmp_path)
        assert result.returncode == 2
        assert "ball_radius.csv:11: a size and a distance above 0" in complaint(result)


def test_standard_output_gets_the_parameters_and_nothing_else(stand, tmp_path):
    picture = tmp_path / "residuals.png"
    result = kelpie("calibrate", "body", stand, "--out", "-", "--picture", picture)
    assert result.returncode == 0 and result.stdout.startswith("# kelpie calibrate body from")
    assert "how far" not in result.stdout and picture.exists()


def test_a_picture_must_be_a_png_and_no_other_output(stand, tmp_path):
    result = kelpie("calibrate", "body", stand, "--picture", tmp_path / "r.jpg")
    assert result.returncode == 2 and ".png" in complaint(result)
    result = kelpie("calibrate", "body", stand, "--out", tmp_path / "r.png", "--picture",
                    f"{tmp_path}/./r.png")
    assert result.returncode == 2 and not (tmp_path / "r.png").exists()
