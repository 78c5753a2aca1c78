# SPDX-License-Identifier: Apache-2.0
"""tools/figures: a figure past its bound fails and says all that one needs. The tree is a small one
of its own, and experiments are stood in for by a program that writes their figures at once."""

import json
import os
import shutil
import subprocess
import tomllib

import pytest
from conftest import BIN, ROOT

DATA = """
seed = 7
seeds = [7, 8, 9]
distance = 4
figures = [
  { what = "ball is seen", run = "objects", key = "recall", bound = ">= 0.94", mean = 0.96, \
sd = 0.005 },
  { what = "pose", run = "walks", key = ["mean", "turned"], take = "max", unit = "cm", \
bound = "<= 3", mean = 2.2, sd = 0.2 },
  { what = "vision", run = "cost", key = "vision/instructions", bound = "<= 1e6", mean = 8e5, \
sd = 1e4 },
]
[run.objects]
trials = 50
seconds = 30
[run.walks]
experiment = "localise"
options = ["--fast"]
seconds = 20
[run.cost]
command = "toolchain/host-cost"
needs = "sh"
"""
PROGRAM = """#!/bin/sh
here=$(dirname "$0")
[ "$1" != --version ] || { echo "kelpie 0.1, commit $(cat "$here/commit"), field lists 0"; exit; }
[ ! -e "$here/broken-$2" ] || { echo "kelpie: $2: no data" >&2; exit 1; }
name=$2
while [ "$1" != --json ]; do [ "$1" != --seed ] || seed=${2%000000}; shift; done
if [ -e "$here/$name-$seed" ]; then cp "$here/$name-$seed" "$2"; else cp "$here/$name" "$2"; fi
"""
COST = """#!/bin/sh
[ "$1 $2 $3" = "--seed 7000000 --json" ] && echo '{"vision": {"instructions": 790000}}' >"$4"
"""
POSE = "pose: 2.20 cm, bound <= 3 (by chance 2.20 sd 0.2, of 3 seeds)"


class Place:
    def __init__(self, folder):
        self.tree, self.bin = folder / "tree", folder / "bin"
        self.data = self.tree / "tools/figures.toml"
        for path in (self.bin, self.tree / "tools", self.tree / "toolchain"):
            path.mkdir(parents=True)
        self.data.write_text(DATA)
        for name in ("figures", "results_data.py", "results_run.py"):
            shutil.copy(ROOT / "tools" / name, self.tree / "tools" / name)
        self.program(self.tree / "toolchain/host-cost", COST)
        for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "a tree"]):
            self.git(*words)
        for name in ("kelpie-experiments", "kelpie-agent", "kelpie-world", "kelpie-percepts",
                     "kelpie"):
            self.program(self.bin / name, PROGRAM)
        (self.bin / "commit").write_text(self.git("rev-parse", "--short", "HEAD"))
        self.give("objects", recall=0.965)
        self.give("localise", mean=2.2, turned=2.0)

    def git(self, *words):
        who = ["-c", "user.name=a", "-c", "user.email=a@b"]
        return subprocess.run(["git", *who, *words], cwd=self.tree, check=True,
                              capture_output=True, text=True).stdout.strip()

    @staticmethod
    def program(path, text):
        path.write_text(text)
        path.chmod(0o755)

    def give(self, name, **figures):
        (self.bin / name).write_text(json.dumps(figures))

    def figures(self, *words):
        return subprocess.run([self.tree / "tools/figures", *words], check=False, timeout=60,
                              env={**os.environ, "KELPIE_BIN": str(self.bin)},
                              capture_output=True, text=True)


@pytest.fixture(name="place")
def tree_whose_figures_hold(tmp_path):
    return Place(tmp_path)


def complaints(result):
    return [line.removeprefix("tools/figures: ") for line in result.stderr.splitlines()[:-1]
            if ", after " not in line]


def test_figures_within_their_bounds_hold(place):
    result = place.figures()
    assert result.returncode == 0, result.stderr
    assert result.stdout.splitlines()[1] == "holds  " + POSE
    assert len(result.stdout.splitlines()) == 3 and complaints(result) == []
    assert result.stderr.splitlines()[-1].startswith("tools/figures: 0 problems, ")


def test_a_figure_past_its_bound_fails_and_says_by_what_it_is_measured(place):
    place.give("localise", mean=2.2, turned=3.31)
    result = place.figures()
    assert result.returncode == 1
    worse = POSE.replace("pose: 2.20", "pose: 3.31")
    assert "WORSE  " + worse in result.stdout.splitlines()
    assert complaints(result) == [
        f"worse: {worse}: kelpie evaluate localise --fast --seed 7000000"]


def test_a_figure_at_its_bound_holds(place):
    place.give("objects", recall=0.94)
    assert place.figures().returncode == 0


def test_what_lies_far_on_the_good_side_is_said(place):
    place.give("objects", recall=0.99)
    result = place.figures()
    assert result.returncode == 0 and result.stdout.startswith("better ball is seen: 0.9900")


def test_an_experiment_that_fails_or_lacks_a_figure_is_a_failure(place):
    (place.bin / "broken-localise").touch()
    place.give("objects", views=3)
    result = place.figures()
    assert result.returncode == 1
    assert sorted(complaints(result)) == [
        "ball is seen: no key 'recall': kelpie evaluate objects --trials 50 --seed 7000000",
        "walks: no data: kelpie evaluate localise --fast --seed 7000000"]


def test_what_the_machine_lacks_a_program_for_is_said_and_no_failure(place):
    place.data.write_text(DATA.replace('needs = "sh"', 'needs = "no-such-program"'))
    result = place.figures()
    assert result.returncode == 0 and len(result.stdout.splitlines()) == 2
    assert complaints(result) == [
        "NOT MEASURED: cost: there is no no-such-program on this machine"]


def test_one_run_alone(place):
    result = place.figures("--only", "walks")
    assert result.stdout.splitlines() == ["holds  " + POSE]
    refused = place.figures("--only", "walk")
    assert refused.returncode == 2 and "no such run; one of objects walks" in refused.stderr


def test_the_list_runs_nothing(place):
    (place.bin / "broken-objects").touch()
    listed = place.figures("--list").stdout.splitlines()
    assert listed[1] == ("walks: pose: <= 3 cm (2.20 sd 0.2): kelpie evaluate localise --fast "
                         "--seed 7000000")
    assert listed[-1] == "3 figures of 3 runs, about 50 s of one core"


def test_values_are_printed_as_lines_of_the_file(place):
    printed = place.figures("--print").stdout
    rows = tomllib.loads(f"rows = [\n{printed}]")["rows"]
    before = tomllib.loads(DATA)["figures"]
    assert [row.pop("mean") for row in rows] == [0.965, 2.2, 790000]
    assert all(old.pop("mean") for old in before) and rows == before


def test_several_seeds_give_mean_spread_and_a_bound_beyond_it(place):
    for seed, mean in ((7, 2.0), (8, 2.2), (9, 2.4)):
        place.give(f"localise-{seed}", mean=mean, turned=1.0)
    printed = place.figures("--print", "--seeds", "7,8,9", "--only", "walks").stdout
    row = tomllib.loads(f"rows = [\n{printed}]")["rows"][0]
    assert (row["mean"], row["sd"], row["bound"]) == (2.2, 0.2, "<= 3")


def test_a_share_of_few_trials_has_the_spread_of_drawing_them(place):
    place.data.write_text(DATA.replace('key = "recall"', 'key = "recall", of = 20'))
    place.give("objects", recall=1.0)
    printed = place.figures("--print", "--seeds", "7,8", "--only", "objects").stdout
    row = tomllib.loads(f"rows = [\n{printed}]")["rows"][0]
    assert (row["mean"], row["sd"], row["bound"]) == (1.0, 0.0487, ">= 0.8051"), "19 of 20 succeed"


def test_programs_of_another_tree_are_refused(place):
    (place.tree / "vision").mkdir()
    (place.tree / "vision/Ball.cpp").write_text("int ball;\n")
    result = place.figures()
    assert result.returncode == 2 and "from which the tree differs in vision" in result.stderr


@pytest.mark.parametrize("wrong, said", [
    ('"<= 3"', "'pose': bound is <= or >= and a number"), ('"walks", ', "'pose': no run 'walk'"),
    ("trials = 50", "run objects: unknown field 'trial'"), ("seed = 7", "no 'seed'")])
def test_a_mistake_in_the_data_file_is_one_line(place, wrong, said):
    right = {'"<= 3"': '"< 3"', '"walks", ': '"walk", ', "trials = 50": "trial = 50",
             "seed = 7": ""}[wrong]
    place.data.write_text(DATA.replace(wrong, right, 1))
    result = place.figures("--list")
    assert result.returncode == 2 and said in result.stderr
    assert len(result.stderr.splitlines()) == 1


# --- the data file of this tree ------------------------------------------------------------------

def data_of_the_tree():
    return tomllib.loads((ROOT / "tools/figures.toml").read_text())


def test_each_bound_lies_beyond_chance():
    data = data_of_the_tree()
    for row in data["figures"]:
        sense, bound = row["bound"].split()
        away = (float(bound) - row["mean"]) * (1 if sense == "<=" else -1)
        assert away >= 0.98 * data["distance"] * max(row["sd"], row.get("least_sd", 0)), row["what"]


def test_each_run_has_a_figure_and_is_an_experiment():
    data = data_of_the_tree()
    assert {row["run"] for row in data["figures"]} == set(data["run"])
    listed = subprocess.run([BIN / "kelpie", "evaluate", "--list"], capture_output=True, text=True,
                            check=True).stdout
    names = {line.split()[0] for line in listed.splitlines()}
    assert {run.get("experiment", name) for name, run in data["run"].items()
            if "command" not in run} <= names
    assert sum(run["seconds"] for run in data["run"].values()) < 500, "five minutes of two cores"
