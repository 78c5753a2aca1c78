# SPDX-License-Identifier: Apache-2.0
"""Experiments on situations: what they say of a team that plays, and of one that stands."""

import json

import pytest
from conftest import ROOT, kelpie

STANDING = ROOT / "tools/experiments/skills/standing"


def figures(tmp_path, name, team, other="teams/thesis", trials=3, minutes=None):
    out = tmp_path / f"{name}.json"
    done = kelpie("evaluate", name, "--a", team, "--trials", str(trials), "--seed", "7100",
                  "--fast", "--json", out, *(["--b", ROOT / other] if other else []),
                  *(["--minutes", str(minutes)] if minutes else []), timeout=300)
    assert done.returncode == 0, done.stderr
    return json.loads(out.read_text())


def test_before_an_open_line_who_plays_scores_and_who_stands_does_not(tmp_path):
    plays = figures(tmp_path, "finish", ROOT / "teams/kelpie")
    assert plays["open_line_goals"] > 0.5 and 2.0 < plays["open_line_after_median_s"] < 15.0
    stands = figures(tmp_path, "finish", STANDING)
    assert stands["goals"] == stands["open_line_goals"] == 0.0


def test_a_ball_that_nobody_plays_is_never_free(tmp_path):
    stands = figures(tmp_path, "stalemate", STANDING, STANDING)
    assert stands["free_within_6s_share"] == 0.0 and stands["post_median_s"] == 100.0
    plays = figures(tmp_path, "stalemate", ROOT / "teams/kelpie")
    assert plays["free_within_6s_share"] > 0.0 and plays["post_median_s"] < 15.0


def test_who_runs_past_an_opponent_has_the_ball_still_and_who_stands_never_had_it(tmp_path):
    plays = figures(tmp_path, "run", ROOT / "teams/kelpie", STANDING, trials=8)
    assert plays["kept_share"] >= 0.25 and 10.0 < plays["speed_median_cm_s"] < 45.0
    assert figures(tmp_path, "run", STANDING, STANDING)["kept_share"] == 0.0


def test_who_is_alone_scores_and_who_stands_does_not(tmp_path):
    plays = figures(tmp_path, "time-to-score", ROOT / "teams/kelpie", other=None)
    assert plays["goals"] > 0.5 and 4.0 < plays["median_s"] < 50.0
    stands = figures(tmp_path, "time-to-score", STANDING, other=None)
    assert stands["goals"] == 0.0 and stands["median_s"] == stands["p90_s"] == 60.0


def test_possessions_of_who_grabs_are_counted_and_who_stands_has_none(tmp_path):
    plays = figures(tmp_path, "possession", ROOT / "teams/thesis", trials=1, minutes=2)
    assert plays["grabs"] > 0 and plays["possessions"] > 3
    shares = [plays[f"{end}_share"] for end in ("chosen", "forced", "lost")]
    assert sum(shares) == pytest.approx(1.0) and 0.0 <= plays["heading_error_median_deg"] < 90.0
    stands = figures(tmp_path, "possession", STANDING, STANDING, trials=1, minutes=1)
    assert stands["grabs"] == stands["possessions"] == 0


@pytest.mark.parametrize("name", ["finish", "stalemate", "run", "rival-attack", "time-to-score"])
def test_a_folder_that_is_no_team_is_told_in_a_line(tmp_path, name):
    done = kelpie("evaluate", name, "--a", tmp_path, "--trials", "1", "--fast")
    assert done.returncode == 2 and str(tmp_path) in done.stderr
