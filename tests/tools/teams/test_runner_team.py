# SPDX-License-Identifier: Apache-2.0
"""The team that plays the pattern of 2005 (teams/runner): it is small, and it runs."""

import json
import re

from conftest import ROOT, kelpie

TEAM = ROOT / "teams/runner"
FILES = sorted(TEAM.glob("*.py"))


def test_it_is_six_modules_that_a_teacher_reads_at_one_sitting():
    assert len(FILES) <= 6
    assert sum(len(file.read_text().splitlines()) for file in FILES) <= 450


def test_it_imports_only_itself_math_and_kelpie():
    own = {file.stem for file in FILES} | {"math", "kelpie"}
    for file in FILES:
        assert set(re.findall(r"^(?:from|import) (\w+)", file.read_text(), re.M)) <= own


def test_in_a_match_its_scripts_fail_nowhere_and_its_forwards_run_and_never_stand(tmp_path):
    out = tmp_path / "runs.json"
    done = kelpie("evaluate", "runs", "--a", ROOT / "teams/thesis", "--b",
                  ROOT / "teams/runner", "--trials", "1", "--minutes", "2", "--fast", "--json", out,
                  timeout=600)
    assert done.returncode == 0, done.stderr
    assert "teams/runner" not in done.stderr  # an error in a script is reported with its file
    runner = json.loads(out.read_text())["b"]
    assert runner["forwards_still_share"] <= 0.03
    assert runner["runs_per_match"] >= 1.0 and runner["run_longest_cm"] >= 150.0
    assert 10.0 < runner["ball_ahead_median_cm"] < 35.0
