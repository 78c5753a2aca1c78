# SPDX-License-Identifier: Apache-2.0
"""`kelpie calibrate kicks` and `evaluate kick-map`: the module that is written, the same each time,
and that the experiment judges what the behaviours read."""

import csv
import signal
import subprocess
import sys
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie

TINY = ("--trials", 1, "--step", 8, "--seed", 3)


@pytest.fixture
def kick_table(monkeypatch):
    """The behaviours' own reader, on the stand-in of what the robot gives them."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "pycode"), str(ROOT / "tests/py"),
                                     str(ROOT / "build/host/generated/python"), *sys.path])
    from lib import kick_table as table
    return table


def test_a_map_is_written_the_same_twice_and_says_how_it_was_made(tmp_path):
    for name in ("one.py", "two.py"):
        result = kelpie("calibrate", "kicks", *TINY, "--out", tmp_path / name)
        assert result.returncode == 0, result.stderr
        assert "upenn_left" in result.stderr
    text = (tmp_path / "one.py").read_text()
    assert text == (tmp_path / "two.py").read_text()
    assert "calibrate kicks --trials 1 --seed 3 --step 8" in text
    assert "models of the seeds 20300 to 20300" in text


def test_a_map_is_python_with_every_outcome_of_six_numbers(tmp_path, kick_table):
    kelpie("calibrate", "kicks", *TINY, "--out", tmp_path / "map.py")
    names = {}
    exec((tmp_path / "map.py").read_text(), names)
    for table in (names["STANDING"], names["WALKING"]):
        for kick in table.values():
            rows = kick["places"]
            assert len(rows) == len(kick["ahead"])
            for row in rows:
                assert len(row) == len(kick["aside"])
                assert all(cell is None or len(cell) == 6 for cell in row)
    assert set(names["HELD"]) == {k for k in kick_table.kicks(True) if k not in kick_table.LEFT_OF}


def test_an_interrupt_is_reported_in_one_line_and_leaves_the_file_as_it_was(tmp_path):
    out = tmp_path / "map.py"
    out.write_text("# of before\n")
    with subprocess.Popen([BIN / "kelpie", "calibrate", "kicks", "--out", out],
                          stderr=subprocess.PIPE, text=True) as run:
        time.sleep(3)
        run.send_signal(signal.SIGINT)
        errors = run.communicate(timeout=60)[1]
    lines = [line for line in errors.splitlines() if line.startswith("kelpie: ")]
    assert run.returncode == 130 and len(lines) == 1 and "interrupted" in lines[0]
    assert out.read_text() == "# of before\n"


def test_a_place_that_cannot_be_written_is_reported_at_once():
    result = kelpie("calibrate", "kicks", "--out", "/nowhere/map.py")
    assert result.returncode == 2 and "cannot be written" in complaint(result)


def test_the_experiment_judges_what_the_behaviours_read(tmp_path, kick_table):
    result = kelpie("evaluate", "kick-map", "--trials", 1, "--seed", 5, "--traces", tmp_path)
    assert result.returncode == 0, result.stderr
    with open(tmp_path / "kicks.csv", encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    assert {row["from"] for row in rows} == {0, 1, 2}
    for row in rows:
        kick, how = int(row["motion"]), row["from"]
        reported = kick_table.held_outcome(kick) if how == 2 else kick_table.outcome(
            kick, row["x_cm"], row["y_cm"], walking=how == 1)
        assert reported[0] == pytest.approx(row["chance"], abs=1e-4)
        if reported[0] > 0:
            assert reported[1] == pytest.approx(row["said_deg"], abs=0.01)
            assert reported[3] == pytest.approx(row["said_cm"], abs=0.01)
