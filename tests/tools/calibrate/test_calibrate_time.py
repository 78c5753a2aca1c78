# SPDX-License-Identifier: Apache-2.0
"""kelpie calibrate time: how old a robot's images are, from a log."""

import re
import tomllib

import pytest
from conftest import ROOT, complaint, kelpie

LOOKING = ROOT / "tools" / "calibrate" / "looking"


def stand(out, *words):
    result = kelpie("play", "--fast", "--pycode", LOOKING, "--seconds", "14", "--seed", "3",
                    "--no-film", "--out", out, *words)
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    return stand(tmp_path_factory.mktemp("stand"))


def milliseconds(log):
    said = kelpie("calibrate", "time", log).stdout
    return float(re.fullmatch(r"images are (\S+) \+- \S+ ms older than .* frames\n", said)[1])


def test_images_of_the_simulated_camera_are_as_old_as_their_stamps(log):
    assert abs(milliseconds(log)) < 6.0


def test_a_robot_that_knows_its_lag_finds_the_same_again(log, tmp_path):
    params = tmp_path / "late.toml"
    params.write_text('[gps.lag]\ninitial = "0.03s"\ninitialSd = "0.001s"\n')
    assert abs(milliseconds(stand(tmp_path / "out", "--params", params))) < 12.0


def test_what_is_found_is_a_file_of_parameters_that_play_takes(log, tmp_path):
    params = tmp_path / "robot.toml"
    said = kelpie("calibrate", "time", log, "--out", params).stdout
    assert said.endswith(f"{params}: parameters, for --params\n")
    lag = tomllib.loads(params.read_text())["gps"]["lag"]
    assert lag["initialSd"].endswith("s") and abs(float(lag["initial"][:-1])) < 0.006
    result = kelpie("play", "--seconds", "1", "--no-film", "--params", params, "--out",
                    tmp_path / "out")
    assert result.returncode in (0, 1), result.stderr


def test_a_log_that_is_none_and_a_target_that_is_the_log_are_one_line(log, tmp_path):
    assert "none.mcap" in complaint(kelpie("calibrate", "time", tmp_path / "none.mcap"))
    assert "is the input itself" in complaint(kelpie("calibrate", "time", log, "--out", log))
