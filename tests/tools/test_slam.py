# SPDX-License-Identifier: Apache-2.0
"""The 2004 localisation challenge, one set-up, from pixels."""

import csv
import json

from conftest import kelpie


def test_one_set_up_is_mapped_and_walked(tmp_path):
    figures = tmp_path / "figures.json"
    result = kelpie("evaluate", "slam", "--trials", "1", "--seed", "31", "--traces", tmp_path,
                    "--json", figures, timeout=600)
    assert result.returncode == 0, result.stderr
    answer = json.loads(figures.read_text())
    assert answer["ghosts"] == 0 and answer["map_p90_cm"] < 15
    assert answer["mean_points"] >= 3
    with open(tmp_path / "slam-31.csv", encoding="ascii") as table:
        rows = list(csv.DictReader(table))
    assert {row["use"] for row in rows} == {"0", "1", "2"}
    halted = [float(row["x_cm"]) for row in rows if 60.0 < float(row["t_s"]) < 62.0]
    assert max(halted) - min(halted) > 1.0  # somebody carried it
