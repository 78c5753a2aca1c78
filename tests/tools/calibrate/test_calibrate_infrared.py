# SPDX-License-Identifier: Apache-2.0
"""kelpie calibrate infrared: when something is in the way, from logs of robots on bare carpet."""

import re

import pytest
from conftest import ROOT, complaint, kelpie

CARPET = ROOT / "tools" / "calibrate" / "carpet"


def stand(out, seed, *options):
    result = kelpie("play", "--fast", "--pycode", CARPET, "--seconds", "14", "--seed", seed,
                    "--no-film", "--out", out, *options)
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


@pytest.fixture(scope="module")
def base(tmp_path_factory):
    """The log of a robot whose sensor reads what is there."""
    return stand(tmp_path_factory.mktemp("base"), 3)


@pytest.fixture(scope="module")
def other(tmp_path_factory):
    """That of one whose sensor differs, elsewhere on the same carpet."""
    return stand(tmp_path_factory.mktemp("other"), 4, "--randomise", "5", "--randomise-only",
                 "infrared")


def numbers(path):
    """gain, offset and threshold of a file of parameters."""
    text = path.read_text()
    assert "[body.infrared]\n" in text
    return [float(re.search(rf'^{key} = "?(-?[0-9.]+)', text, re.M)[1])
            for key in ("gain", "offset", "threshold")]


def carpet(result):
    return float(re.search(r"stance with a ball +([0-9.]+) cm", result.stdout)[1])


def test_the_threshold_is_four_fifths_of_what_the_carpet_reads(base, tmp_path):
    out = tmp_path / "robot.toml"
    result = kelpie("calibrate", "infrared", base, "--out", out)
    assert result.returncode == 0, result.stderr
    gain, offset, threshold = numbers(out)
    assert (gain, offset) == (1.0, 0.0)
    assert abs(threshold - 0.8 * carpet(result)) < 0.02
    assert 15.0 < threshold < 35.0


def test_a_line_makes_the_readings_of_another_robot_those_of_the_base_robot(base, other, tmp_path):
    out, again = tmp_path / "robot.toml", tmp_path / "again"
    result = kelpie("calibrate", "infrared", other, "--base", base, "--out", out)
    assert result.returncode == 0, result.stderr
    gain, offset, threshold = numbers(out)
    assert (gain, offset) != (1.0, 0.0) and "of 5 poses" in result.stdout
    read = carpet(kelpie("calibrate", "infrared", base))
    assert abs(threshold - 0.8 * read) < 0.02
    # With its file the robot reads of the carpet what the base robot does.
    raw = carpet(kelpie("calibrate", "infrared", other))
    log = stand(again, 4, "--randomise", "5", "--randomise-only", "infrared", "--params", out)
    converted = carpet(kelpie("calibrate", "infrared", log))
    assert abs(converted - read) < 0.3 < abs(raw - read)


def test_standard_output_gets_the_parameters_and_nothing_else(base):
    result = kelpie("calibrate", "infrared", base, "--out", "-")
    assert result.returncode == 0 and result.stdout.startswith("# kelpie calibrate infrared from")
    assert "mean of" not in result.stdout


def test_a_robot_that_plays_tells_nothing(match, tmp_path):
    out = tmp_path / "robot.toml"
    result = kelpie("calibrate", "infrared", match, "--out", out)
    assert result.returncode == 2 and not out.exists()
    assert "match.mcap: " in complaint(result)


def test_what_is_no_log_and_an_input_as_output_are_refused(base, tmp_path):
    result = kelpie("calibrate", "infrared", tmp_path / "none.mcap")
    assert result.returncode == 2 and "none.mcap" in complaint(result)
    result = kelpie("calibrate", "infrared", base, "--base", tmp_path / "none.mcap")
    assert result.returncode == 2 and "none.mcap" in complaint(result)
    result = kelpie("calibrate", "infrared", base, "--out", base)
    assert result.returncode == 2 and "is the input itself" in complaint(result)
    result = kelpie("calibrate", "infrared", base, "--out", tmp_path / "no" / "robot.toml")
    assert result.returncode == 2 and "cannot be written" in complaint(result)
