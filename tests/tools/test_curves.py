# SPDX-License-Identifier: Apache-2.0
"""tools/curves: the learned log odds of an object become a file of vision."""
import pathlib
import runpy
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
CURVES = runpy.run_path(str(ROOT / "tools/curves"))
FIGURES = {"trials": 7, "seed": 11, "beacons": {"prior": -1.5, "curves": [
    {"fact": "onWhite", "at": [0, 1], "log_odds": [0.5, -0.25]}]}}


def test_file_names_the_command_that_learned_it():
    assert "kelpie evaluate doubts --trials 7 --seed 11" in CURVES["source"](FIGURES, "beacons")


def test_curve_of_fewer_knots_repeats_the_last():
    text = CURVES["source"](FIGURES, "beacons")
    assert "{&BeaconFacts::onWhite,\n     {0, 1, 1, 1, 1, 1},\n" in text
    assert "{0.5, -0.25, -0.25, -0.25, -0.25, -0.25}}" in text


def test_unknown_object_is_a_usage_error():
    result = subprocess.run([str(ROOT / "tools/curves"), "x.json", "trees"], capture_output=True,
                            text=True, check=False)
    assert result.returncode == 2 and all(kind in result.stderr for kind in CURVES["ROOMS"])
