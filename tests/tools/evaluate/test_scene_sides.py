# SPDX-License-Identifier: Apache-2.0
"""Two teams in the same situations, as an experiment."""

import json

import pytest
from conftest import ROOT, kelpie

STANDS = "import kelpie\n\n\ndef decide(world):\n    return kelpie.Command()\n"


def test_each_kind_is_played_in_both_colours_and_against_statues_a_team_scores(tmp_path):
    statues = tmp_path / "statues"
    statues.mkdir()
    (statues / "main.py").write_text(STANDS)
    out = tmp_path / "scenes.json"
    done = kelpie("evaluate", "scenes", "--a", ROOT / "teams/kelpie", "--b", statues, "--trials",
                  "1", "--seed", "4", "--json", out, timeout=600)
    assert done.returncode == 0, done.stderr
    figures = json.loads(out.read_text())
    assert figures["scenes"] == 2 * len(figures["kinds"]) == 38
    assert figures["goals_for"] >= 0.1 and figures["goals_against"] == 0.0
    low, mean, high = (figures["goals_difference" + end] for end in ("_low", "", "_high"))
    assert low <= mean <= high and mean > 0.0


@pytest.mark.parametrize("words, said", [
    (["--a", "nowhere"], "--a: Directory does not exist: nowhere"),
    (["--b", "nowhere"], "--b: Directory does not exist: nowhere")])
def test_a_team_that_is_not_there_is_refused_in_a_line(words, said):
    refused = kelpie("evaluate", "scenes", *words)
    assert refused.returncode == 2
    assert said in refused.stderr and len(refused.stderr.splitlines()) == 1
