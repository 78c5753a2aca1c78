# SPDX-License-Identifier: Apache-2.0
"""tools/results: figures of experiments become docs/results.md, and are measured again where they
are stale. The tree is a small one of its own, and experiments are stood in for by a program that
writes their figures at once."""

import json
import os
import re
import shutil
import subprocess
import tomllib

import pytest
from conftest import ROOT, kelpie

DATA = """
seeds = [7, 8, 9]
[files]
play = ["vision", "pycode"]
[run.objects]
trials = 50
seconds = 30
[run.distances]
seeded = false
files = ["robot/Sizes.h"]
[[subject]]
title = "Vision"
text = "Random views."
run = "objects"
rows = [
  { what = "recall", key = "recall", digits = 3, required = ">= 0.9" },
  { what = "error", key = "error_cm", digits = 1, unit = "cm", required = "<= 3" },
  { what = "ghosts", key = "ghosts", digits = 0, required = "= 0" },
  { what = "plain", key = "error_cm", digits = 0, unit = "cm" },
  { what = "of band 50", key = "bands/from_cm=50/recall", factor = 100, digits = 0, unit = "%" },
  { what = "of the second band", key = "bands/1/from_cm", digits = 0, unit = "cm" },
  { what = "worst channel", key = ["centred/*", "moved/*"], digits = 1 },
  { what = "all channels", key = "centred/*", take = "sum", digits = 1 },
  { what = "a share", key = ["ghosts", "views"], take = "ratio", digits = 3 },
  { what = "fused", key = "fused", required = "< own", required_says = "below its own", \
reference_key = "own", source = "alone" },
  { what = "fit", run = "distances", key = "rms_cm", digits = 1, unit = "cm", \
reference = "4.7 cm", source = "2005 code" },
]
[[subject]]
title = "Cost"
rows = [
  { what = "cycles", command = "toolchain/target-cost", value = 2.31, unit = "M", \
required = "<= 4", date = "2026-11-22", commit = "abc1234" },
  { what = "lack", command = "the same", stated = "names Eigen", \
required = "fails", verdict = "missed", files = ["robot"], date = "2026-11-22", \
commit = "abc1234" },
]
"""
FIGURES = {"views": 100, "ghosts": 0, "fused": 1.4, "own": 2.2, "recall": 0.95, "error_cm": 2.0,
           "bands": [{"from_cm": 25.0, "recall": 0.1}, {"from_cm": 50.0, "recall": 0.5}],
           "centred": {"y": 0.1, "cr": 0.7}, "moved": {"y": 0.3}}
FILES = {"vision/Ball.cpp": "int ball;\n", "vision/README.md": "Finds balls.\n",
         "pycode/main.py": "pass\n", "robot/Sizes.h": "int size;\n", "docs/ball.md": "A ball.\n",
         ".gitignore": "out/\n__pycache__/\n"}
PROGRAM = """#!/bin/sh
here=$(dirname "$0")
[ "$1" != --version ] || { echo "kelpie 0.1, commit $(cat "$here/commit"), field lists 0"; exit; }
echo "$*" >>"$here/calls"
if [ -e "$here/broken-$2" ]; then
  echo "kelpie: $2: no data" >&2; exit 1
fi
name=$2; seed=7
while [ "$1" != --json ]; do [ "$1" != --seed ] || seed=${2%000000}; shift; done
[ ! -e "$here/slow-$name" ] || sleep 0.2
cp "$here/$name-$seed" "$2"
echo "$name ended" >>"$here/ends"
"""


class Place:
    """A tree with tools/results, and programs that give the figures that `give` was given."""

    def __init__(self, folder):
        self.tree, self.bin = folder / "tree", folder / "bin"
        self.page = self.tree / "docs/results.md"
        self.data = self.tree / "tools/experiments/results.toml"
        self.kept = self.tree / "tools/experiments/measured.json"
        self.bin.mkdir()
        for path, text in {**FILES, "tools/experiments/results.toml": DATA}.items():
            self.change(path, text)
        for name in ("results", "results_data.py", "results_page.py", "results_run.py"):
            shutil.copy(ROOT / "tools" / name, self.tree / "tools" / name)
        self.git("init", "-q")
        self.commit()
        self.change("tools/experiments/results.toml", DATA.replace("abc1234", self.head()))
        for name in ("kelpie-experiments", "kelpie-agent", "kelpie-world", "kelpie-percepts",
                     "kelpie"):
            (self.bin / name).write_text(PROGRAM)
            (self.bin / name).chmod(0o755)
        for seed, error, recall, ghosts in ((7, 2.0, 0.95, 0), (8, 3.5, 0.89, 1),
                                            (9, 2.9, 0.88, 0)):
            self.give("objects", seed, {**FIGURES, "error_cm": error, "recall": recall,
                                        "ghosts": ghosts})
        self.give("distances", 7, {"rms_cm": 4.1})

    def git(self, *words):
        who = ["-c", "user.name=a", "-c", "user.email=a@b"]
        return subprocess.run(["git", *who, *words], cwd=self.tree, check=True,
                              capture_output=True, text=True).stdout.strip()

    def change(self, path, text):
        (self.tree / path).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / path).write_text(text)

    def commit(self):
        """Commits the tree and has the programs built from it."""
        self.git("add", ".")
        self.git("commit", "-q", "--allow-empty", "-m", "a change")
        (self.bin / "commit").write_text(self.head())

    def head(self):
        return self.git("rev-parse", "--short", "HEAD")

    def give(self, name, seed, figures):
        (self.bin / f"{name}-{seed}").write_text(json.dumps(figures))

    def results(self, *words):
        return subprocess.run([self.tree / "tools/results", *map(str, words)], check=False,
                              env={**os.environ, "KELPIE_BIN": str(self.bin)}, timeout=60,
                              capture_output=True, text=True)

    def measure(self, *words):
        """The words with which experiments were run."""
        (self.bin / "calls").unlink(missing_ok=True)
        result = self.results(*words)
        assert result.returncode == 0, result.stderr
        calls = self.bin / "calls"
        return calls.read_text().splitlines() if calls.exists() else []

    def stale(self, *words):
        lines = self.results("--list", *words).stdout.splitlines()
        return dict(line.split(": ", 1) for line in lines[:-1])

    def row(self, what):
        """The cells of a row of the page without its name, command included."""
        lines = [line for line in self.page.read_text().splitlines()
                 if line.startswith(f"| {what} |")]
        assert len(lines) == 1, f"{what}: {lines}"
        return [cell.strip() for cell in lines[0].strip("|").split("|")][1:]


@pytest.fixture(name="fresh")
def tree_without_figures(tmp_path):
    return Place(tmp_path)


@pytest.fixture(name="place")
def tree_with_figures(fresh):
    assert len(fresh.measure()) == 4
    fresh.git("add", ".")
    return fresh


def problems(result):
    return [line for line in result.stderr.splitlines() if "written" not in line]


# --- rows ----------------------------------------------------------------------------------------

def test_a_figure_is_the_mean_with_its_spread(place):
    assert place.row("recall")[1] == "0.907 (0.880 to 0.950)"
    assert place.row("error")[1] == "2.8 cm (2.0 to 3.5)"
    assert place.row("plain")[1:5] == ["3 cm (2 to 4)", "-", "-", "-"]
    assert place.row("fit")[1] == "4.1 cm", "what draws nothing is measured once"


def test_what_every_seed_meets_is_met_what_the_mean_does_not_is_missed(place):
    assert place.row("fused")[1:5] == ["1.40", "below its own", "met", "2.20 (alone)"]
    assert place.row("recall")[2:4] == [">= 0.9", "met on average"]
    assert place.row("error")[2:4] == ["<= 3 cm", "met on average"]
    assert place.row("ghosts")[1:4] == ["0 (0 to 1)", "= 0", "**missed**"]
    page = place.page.read_text()
    assert "6 figures have a requirement: 2 met, 2 met on average, 2 missed" in page
    assert "| **missed** | Vision | ghosts | 0 (0 to 1) | = 0 |" in page


def test_a_key_reaches_into_lists_and_takes_several_values(place):
    assert place.row("of band 50")[1] == "50 %"
    assert place.row("of the second band")[1] == "50 cm"
    assert place.row("worst channel")[1] == "0.7"
    assert place.row("all channels")[1] == "0.8"
    assert place.row("a share")[1] == "0.003 (0.000 to 0.010)"


def test_what_is_measured_by_hand_says_so(place):
    assert place.row("cycles") == ["`toolchain/target-cost`", "2.31 M", "<= 4 M", "met", "-",
                                   f"{place.head()} 2026-11-22 by hand"]
    assert place.row("lack")[:4] == ["the same", "names Eigen", "fails", "**missed**"]


def test_commands_commit_seeds_and_warning_stand_on_the_page(place):
    page = place.page.read_text()
    assert place.row("recall")[0] == "`kelpie evaluate objects --trials 50 --seed 7000000`"
    assert place.row("error")[0] == "the same"
    assert place.row("fit")[3:5] == ["-", "4.7 cm (2005 code)"]
    assert re.fullmatch(place.head() + r" \d{4}-\d\d-\d\d", place.row("recall")[5])
    head = page.split("\n## ")[0]
    for said in ("no proof for a robot", "seeds are 7 and 8 and 9", "--seed 7000000"):
        assert said in head
    assert "| objects | `kelpie evaluate objects --trials 50 --seed 7000000` | 0.0 |" in page


def test_a_missing_key_is_said_in_its_row_and_in_one_line(fresh):
    fresh.give("objects", 8, {k: v for k, v in FIGURES.items() if k != "recall"})
    result = fresh.results()
    assert result.returncode == 1
    assert problems(result)[-1] == "tools/results: objects: no key 'recall'"
    assert fresh.row("recall")[1:4] == ["not measured (no key 'recall')", ">= 0.9", "not measured"]
    assert fresh.row("fused")[3] == "met"
    assert fresh.stale() == {}, "an experiment that does not have it is not run again for it"


@pytest.mark.parametrize("wrong, said", [
    ('digits = 3, required = ">= 0.9"', "unknown field 'digit'"),
    ('required = ">= 0.9"', "required is a comparison"),
    ('run = "objects"', "no run 'object'"),
    (', commit = "abc1234"', "no 'commit'")])
def test_a_mistake_in_the_data_file_is_one_line(fresh, wrong, said):
    change = {"digits": wrong.replace("digits", "digit"), "required": 'required = "about 0.9"',
              "run": 'run = "object"', ",": ""}[wrong.split()[0]]
    fresh.data.write_text(DATA.replace(wrong, change, 1))
    result = fresh.results("--page")
    assert result.returncode == 2 and not fresh.page.exists()
    assert len(problems(result)) == 1 and said in result.stderr


# --- what is stale -------------------------------------------------------------------------------

def test_what_is_not_stale_is_not_measured(place):
    assert place.stale() == {} and place.measure() == []


def test_a_changed_file_makes_stale_what_depends_on_it(place):
    place.change("vision/Ball.cpp", "int ball, beacon;\n")
    assert list(place.stale()) == ["objects"]
    assert place.stale()["objects"].startswith("changed: vision;"), "though it is not committed"
    place.results("--page")
    assert place.row("recall")[5].endswith(" code changed since")
    assert re.fullmatch(r"\w+ [\d-]+", place.row("fit")[5]), "it depends on other files"
    assert "1 of 2 runs are stale" in place.page.read_text()
    place.git("checkout", "-q", "vision")
    assert place.stale() == {}


def test_the_summary_counts_what_was_measured_of_other_code(place):
    assert "Of those measured the code of 0 has changed since." in place.page.read_text()
    place.change("vision/Ball.cpp", "int ball, beacon;\n")
    place.results("--page")
    page = place.page.read_text()
    assert "Of those measured the code of 5 has changed since." in page, "four rows, one by hand"
    assert re.search(r"\| ghosts \| 0 \(0 to 1\) \| = 0 \| \w+ [\d-]+ code changed since \|", page)


def test_git_tells_of_what_was_measured_by_hand_that_its_code_has_changed(place):
    place.change("pycode/main.py", "x = 1\n")
    place.commit()
    place.results("--page")
    assert place.row("cycles")[5].endswith(" by hand code changed since")
    assert place.row("lack")[5].endswith(" by hand"), "it names other files"
    place.git("checkout", "-q", "HEAD~1", "pycode")
    place.results("--page")
    assert place.row("cycles")[5].endswith(" by hand"), "not even committed"


def test_a_commit_that_git_does_not_know_is_stale(place):
    place.data.write_text(DATA)
    assert place.results("--page").returncode == 0
    assert place.row("cycles")[5] == "abc1234 2026-11-22 by hand stale"


def test_a_new_file_makes_stale_though_it_is_not_known_to_git(place):
    place.change("vision/Beacon.cpp", "int beacon;\n")
    assert list(place.stale()) == ["objects"]


def test_documents_tests_and_moved_files_make_nothing_stale(place):
    place.change("docs/ball.md", "Another ball.\n")
    place.change("vision/README.md", "Finds beacons.\n")
    place.change("pycode/test_main.py", "pass\n")
    place.git("add", ".")
    place.git("mv", "vision/Ball.cpp", "vision/Balls.cpp")
    assert place.stale() == {}


def test_other_trials_and_seeds_and_a_new_row_make_stale(place):
    for old, new in (("trials = 50", "trials = 51"), ("seeds = [7, 8, 9]", "seeds = [7, 8]")):
        place.data.write_text(DATA.replace(old, new))
        assert [why[:11] for why in place.stale().values()] == ["measured by"]
    place.data.write_text(DATA.replace('what = "plain", key = "error_cm"',
                                       'what = "plain", key = "views"'))
    assert place.stale()["objects"].startswith("new rows: views")
    assert place.measure() == [], "it is in the whole figures of each seed"
    assert place.row("plain")[1] == "100 cm"


def test_the_list_says_how_long_it_takes(fresh):
    listed = fresh.results("--list").stdout.splitlines()
    assert listed == ["objects: never measured; 90 s", "distances: never measured; 0 s",
                      "2 of 2 runs, about 2 minutes of one core"]
    assert fresh.results("--list", "--only", "distances").stdout.splitlines()[-1] == (
        "1 of 1 runs, about 0 minutes of one core")


# --- measuring -----------------------------------------------------------------------------------

def test_a_row_keeps_the_commit_of_its_figure(place):
    before = place.head()
    place.change("robot/Sizes.h", "int size, width;\n")
    place.commit()
    place.give("distances", 7, {"rms_cm": 4.4})
    assert place.measure() == [f"evaluate distances --json {place.tree}/out/results/"
                               "distances-7.part"]
    assert before != place.head()
    assert place.row("recall")[5].split()[0] == before and place.row("recall")[1].startswith("0.9")
    assert place.row("fit")[5].split()[0] == place.head() and place.row("fit")[1] == "4.4 cm"


def test_an_interrupted_call_goes_on_where_it_stopped(fresh):
    (fresh.bin / "broken-distances").touch()
    assert fresh.results().returncode == 1
    (fresh.bin / "broken-distances").unlink()
    (fresh.tree / "out/results/objects-8.json").unlink()
    shutil.move(fresh.kept, fresh.kept.with_suffix(".lost"))
    calls = fresh.measure()
    assert sorted(re.findall(r"objects|distances|--seed \d+", " ".join(calls))) == [
        "--seed 8000000", "distances", "distances", "objects", "objects"]


def test_figures_of_each_seed_are_of_the_files_that_are_there(place):
    place.kept.unlink()
    place.change("vision/Ball.cpp", "int beacon;\n")
    place.commit()
    calls = place.measure()
    assert len(calls) == 3 and all("objects" in call for call in calls)


def test_all_is_measured_where_that_is_asked_for(place):
    assert len(place.measure("--all")) == 4
    assert len(place.measure("--all", "--only", "distances")) == 1


def test_what_all_did_not_come_to_is_stale(place):
    (place.bin / "broken-objects").touch()
    assert place.results("--all").returncode == 1
    assert list(place.stale()) == ["objects"]
    place.results("--page")
    assert place.row("recall")[1] == "0.907 (0.880 to 0.950)" and "stale" in place.row("recall")[5]


def test_what_times_by_the_clock_is_run_while_nothing_else_is(fresh):
    alone = "seeded = false\nseconds = 99\nalone = true"
    fresh.data.write_text(DATA.replace("seeded = false", alone))
    (fresh.bin / "slow-objects").touch()
    fresh.measure("--jobs", "4")
    assert (fresh.bin / "ends").read_text().split() == 3 * ["objects", "ended"] + ["distances",
                                                                                  "ended"]


def test_only_runs_that_are_named_are_measured(fresh):
    calls = fresh.measure("--only", "distances")
    assert len(calls) == 1 and "distances" in calls[0]
    assert fresh.row("recall")[1] == "not measured (not run yet)"
    refused = fresh.results("--only", "distance")
    assert refused.returncode == 2 and "no such run; one of objects distances" in refused.stderr


def test_programs_of_another_tree_are_refused(place):
    place.change("vision/Ball.cpp", "int beacon;\n")
    result = place.results()
    assert result.returncode == 2 and "from which the tree differs in vision" in result.stderr
    place.git("checkout", "-q", "vision")
    place.change("pycode/main.py", "x = 1\n")
    assert len(place.measure()) == 3, "behaviours are read while a program runs"
    assert place.row("recall")[5].split()[0] == f"{place.head()}-dirty"


def test_an_experiment_that_fails_is_said_and_what_was_before_stays(place):
    place.change("robot/Sizes.h", "int width;\n")
    place.commit()
    (place.bin / "broken-distances").touch()
    result = place.results()
    assert result.returncode == 1
    assert "tools/results: distances: no data" in result.stderr.splitlines()
    assert place.row("fit")[1] == "4.1 cm" and place.row("fit")[5].endswith(" code changed since")


def test_the_page_is_the_same_each_time_it_is_written(place):
    before = place.page.read_bytes()
    place.page.unlink()
    for _ in range(2):
        assert place.results("--page").returncode == 0 and place.page.read_bytes() == before


def test_help_and_wrong_seeds(fresh):
    shown = fresh.results("--help")
    assert shown.returncode == 0 and shown.stdout.startswith("usage: tools/results ")
    wrong = fresh.results("--page", "--seeds", "1,1")
    assert wrong.returncode == 2 and "different whole numbers" in wrong.stderr


# --- the data file and the page of this tree -----------------------------------------------------

def data_of_the_tree():
    return tomllib.loads((ROOT / "tools/experiments/results.toml").read_text())


def test_every_experiment_has_a_run_and_rows():
    data = data_of_the_tree()
    names = set(re.findall(r"^(\S+)", kelpie("evaluate", "--list").stdout, re.M))
    run_names = {run.get("experiment", name) for name, run in data["run"].items()}
    assert len(names) > 50 and names == run_names
    stated = {row.get("run", subject.get("run")) for subject in data["subject"]
              for row in subject["rows"] if "key" in row}
    assert stated == set(data["run"]), "every run is stated in some row"


def test_what_runs_depend_on_exists():
    data = data_of_the_tree()
    sets = data["files"]
    named = {path for run in data["run"].values() for path in run.get("files", [])}
    paths = {path for paths in sets.values() for path in paths} | (named - set(sets))
    assert len(paths) > 10 and [path for path in sorted(paths) if not (ROOT / path).exists()] == []


def test_the_page_of_the_tree_is_what_is_kept(tmp_path):
    """But for what is stale, which each change of a stage changes."""
    written = subprocess.run([ROOT / "tools/results", "--page", "--out", tmp_path / "page.md"],
                             capture_output=True, text=True, timeout=60, check=False)
    assert written.returncode in (0, 1), written.stderr

    def timeless(text):
        text = re.sub(r"\d+ of \d+ runs are stale|the code of \d+ has changed", "", text)
        text = re.sub(r" (stale|code changed since) \|", " |", text)
        return re.sub(r"\| (changed|measured|new rows|to be)[^|]* \|$", "| - |", text, flags=re.M)
    page = (ROOT / "docs/results.md").read_text()
    assert timeless((tmp_path / "page.md").read_text()) == timeless(page)
