# SPDX-License-Identifier: Apache-2.0
"""kelpie evaluate: which experiments there are and which options each of them uses."""

import json
import re

import pytest
from conftest import ROOT, complaint, kelpie


@pytest.mark.parametrize("words, refused, known", [
    (["ball", "--params", "CMakeLists.txt"], "--params", "--trials, --seed, --json"),
    (["team-ball", "--randomise", "3"], "--randomise", "--trials, --seed, --json"),
    (["kidnap", "--pictures", "."], "--pictures",
     "--seed, --randomise, --params, --traces, --fast, --json"),
    (["objects", "--traces", "."], "--traces", "--trials, --seed, --randomise, --pictures, --json"),
    (["walk-and-kick", "--trials", "1"], "--trials", "--seed, --json"),
    (["distances", "--seed", "1"], "--seed", "knows --json"),
])
def test_an_option_that_an_experiment_does_not_use_is_refused(words, refused, known):
    result = kelpie("evaluate", *words)
    assert result.returncode == 2 and result.stdout == ""
    assert f"{words[0]} does not use {refused}" in complaint(result)
    assert known in complaint(result)


def test_list_with_a_name_lists_that_one_and_refuses_one_that_is_not_there():
    lines = kelpie("evaluate", "--list", "spoilt").stdout.splitlines()
    assert [line.split()[0] for line in lines] == ["spoilt", "--trials"]
    assert "no experiment 'nosuch'" in complaint(kelpie("evaluate", "--list", "nosuch"))


def test_help_lists_the_experiments_by_name_one_line_each():
    text = kelpie("evaluate", "--help").stdout
    lines = text[text.index("Experiments:"):].splitlines()[1:]
    lines = [line for line in lines if line.strip()]
    names = [line.split()[0] for line in lines]
    assert len(names) >= 27 and names == sorted(names) and {"ball", "slam"} <= set(names)
    assert all(len(line) <= 100 and len(line.split()) > 3 for line in lines)


def test_every_result_begins_with_the_experiment_its_trials_and_its_seed():
    result = kelpie("evaluate", "team-ball", "--trials", "2", "--seed", "5")
    assert list(json.loads(result.stdout).items())[:3] == [("experiment", "team-ball"),
                                                           ("trials", 2), ("seed", 5)]


def test_every_command_of_the_figures_names_an_experiment_and_options_that_it_uses():
    options, name = {}, ""
    for line in kelpie("evaluate", "--list").stdout.splitlines():
        if line[0] != " ":
            name = line.split()[0]
            options[name] = {"--json"}
        else:
            options[name] |= set(re.findall(r"--\w+", line))
    docs = [(ROOT / "docs" / name).read_text() for name in ("results.md", "decisions.md")]
    commands = re.findall(r"`kelpie evaluate\s+([a-z-]+)([^`]*)`", "".join(docs))
    assert len(commands) > 20
    for name, words in commands:
        assert set(re.findall(r"--\w+", words)) <= options[name], name
