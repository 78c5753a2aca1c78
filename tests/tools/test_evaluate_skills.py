# SPDX-License-Identifier: Apache-2.0
"""The experiments that play tries of a skill, with one trial each on the kinematic body."""

import json

import pytest
from conftest import complaint, kelpie

# Each with keys of its figures, "/" between those of a part.
KEYS = {
    "bird-of-prey": ["bird_of_prey/median_s", "straight/median_s", "straight/contacts_per_try"],
    "distributed-find": ["together/median_s", "alone/found_rate"],
    "aim": ["sight/spread_deg", "pose/on_target_rate"],
    "dodge": ["dodge/passed_rate", "no_dodge/shots_passed_rate"],
    "find-ball": ["chain_over_spin", "hidden/chain_median_s", "under_chin/spin_median_s"],
    "goalie": ["ratio_to_empty", "ratio_2004_to_empty", "own_goals", "goalie_outside_box"],
    "grab-dribble": ["success", "violations_3s", "violations_50cm", "grab_frames"],
    "intercept": ["intercept/reached_rate", "walk_at/median_s"],
    "kick-choice": ["rules/goals_rate", "map/goals_rate"],
    "ready": ["all_at_place_share", "robots_at_place_share", "median_s"],
    "score-empty-goal": ["goals_rate", "median_s", "goals_rate_no_grab", "median_no_grab_s"],
}


def evaluated(name, *words):
    result = kelpie("evaluate", name, "--fast", "--trials", "1", *words)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


@pytest.mark.parametrize("name", KEYS)
def test_a_try_of_each_way_gives_its_figures(name):
    figures = evaluated(name, "--seed", "77")
    for path in KEYS[name]:
        value = figures
        for key in path.split("/"):
            value = value[key]
        assert isinstance(value, (int, float)) and value >= 0


def test_the_same_seed_gives_the_same_figures_on_any_number_of_cores():
    tries = [kelpie("evaluate", "grab-dribble", "--fast", "--trials", "3", "--seed", "5").stdout
             for _ in range(2)]
    assert tries[0] == tries[1] and json.loads(tries[0])["trials"] == 3


def test_a_grab_takes_twelve_frames_or_six_and_a_robot_that_may_not_grab_does_not(tmp_path):
    words = ("evaluate", "grab-dribble", "--fast", "--trials", "4", "--seed", "77")
    figures = json.loads(kelpie(*words).stdout)
    assert figures["grabs"] > 0 and figures["kept_rate"] > 0
    # The motion lasts 0.4 s, which images, not in step with the legs, show as 11 to 13 of them; the
    # quick one half as long.
    assert figures["grab_frames"] == 0 or 11 <= figures["grab_frames"] <= 13
    assert figures["grab_frames_quick"] == 0 or 5 <= figures["grab_frames_quick"] <= 7
    params = tmp_path / "p.toml"
    params.write_text("[behaviour.task]\ngrab = false\n")
    assert json.loads(kelpie(*words, "--params", params).stdout)["grabs"] == 0


def test_parameters_that_are_wrong_end_an_experiment_with_one_line(tmp_path):
    params = tmp_path / "p.toml"
    params.write_text("[behaviour.task]\ngrap = true\n")
    result = kelpie("evaluate", "aim", "--fast", "--trials", "1", "--params", params)
    assert result.returncode == 2
    assert "unknown key behaviour.task.grap" in complaint(result)
