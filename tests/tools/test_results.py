# SPDX-License-Identifier: Apache-2.0
"""tools/results: figures of experiments become docs/results.md. Experiments are stood in for by
files or by a program that writes such files at once."""

import json
import os
import re
import subprocess
import tomllib

import pytest
from conftest import ROOT, kelpie

DATA = """
[run.objects]
trials = 50
[run.distances]
seeded = false
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
  { what = "worst channel", key = ["centred/*", "moved/*"], digits = 1 },
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
required = "<= 4", date = "2026-11-22" },
  { what = "lack", command = "the same", told = "names Eigen", \
required = "fails", verdict = "missed", date = "2026-11-22" },
]
"""
FIGURES = {"views": 100, "ghosts": 0, "fused": 1.4, "own": 2.2, "recall": 0.95, "error_cm": 2.0,
           "bands": [{"from_cm": 25.0, "recall": 0.1}, {"from_cm": 50.0, "recall": 0.5}],
           "centred": {"y": 0.1, "cr": 0.7}, "moved": {"y": 0.3}}


def run(*words, **environment):
    command = [str(word) for word in (ROOT / "tools/results", *words)]
    return subprocess.run(command, env={**os.environ, **environment}, capture_output=True,
                          text=True, timeout=60, check=False)


class Place:
    """A data file, a folder of figures and a page of their own."""

    def __init__(self, folder):
        self.data, self.kept, self.page = folder / "data.toml", folder / "kept", folder / "page.md"
        self.kept.mkdir()
        self.data.write_text(DATA)

    def keep(self, name, seed, figures, trials=50):
        command = (f"kelpie evaluate {name} --trials {trials} --seed {seed * 1000000}" if trials
                   else f"kelpie evaluate {name}")
        made_by = {"command": command, "commit": "abc1234", "cpu_s": 12.5}
        path = self.kept / f"{name}-{seed}.json"
        path.write_text(json.dumps({**figures, "made_by": made_by}))

    def results(self, *words, **environment):
        return run("--data", self.data, "--json", self.kept, "--out", self.page, "--seeds", "7,8,9",
                   *words, **environment)

    def row(self, what):
        """The cells of a row of the page without its name, command included."""
        lines = [line for line in self.page.read_text().splitlines()
                 if line.startswith(f"| {what} |")]
        assert len(lines) == 1, f"{what}: {lines}"
        return [cell.strip() for cell in lines[0].strip("|").split("|")][1:]


@pytest.fixture(name="place")
def place_with_figures(tmp_path):
    place = Place(tmp_path)
    for seed, error, recall, ghosts in ((7, 2.0, 0.95, 0), (8, 3.5, 0.89, 1), (9, 2.9, 0.88, 0)):
        place.keep("objects", seed, {**FIGURES, "error_cm": error, "recall": recall,
                                     "ghosts": ghosts})
    place.keep("distances", 7, {"rms_cm": 4.1}, trials=None)
    return place


def problems(result):
    return [line for line in result.stderr.splitlines() if "written" not in line]


def test_a_figure_is_the_mean_with_its_spread(place):
    result = place.results("--render")
    assert result.returncode == 0 and problems(result) == []
    assert place.row("recall")[1] == "0.907 (0.880 to 0.950)"
    assert place.row("error")[1] == "2.8 cm (2.0 to 3.5)"
    assert place.row("plain")[1:] == ["3 cm (2 to 4)", "-", "-", "-"]
    assert place.row("fit")[1] == "4.1 cm", "what draws nothing is measured once"


def test_what_every_seed_meets_is_met_what_the_mean_does_not_is_missed(place):
    place.results("--render")
    assert place.row("fused")[1:] == ["1.40", "below its own", "met", "2.20 (alone)"]
    assert place.row("recall")[2:4] == [">= 0.9", "met on average"]
    assert place.row("error")[2:4] == ["<= 3 cm", "met on average"]
    assert place.row("ghosts")[1:4] == ["0 (0 to 1)", "= 0", "**missed**"]
    page = place.page.read_text()
    assert "6 figures have a requirement: 2 met, 2 met on average, 2 missed" in page
    assert "- **missed**: Vision: ghosts: 0 (0 to 1), required = 0" in page


def test_a_key_reaches_into_lists_and_takes_several_values(place):
    place.results("--render")
    assert place.row("of band 50")[1] == "50 %"
    assert place.row("worst channel")[1] == "0.7"
    assert place.row("a share")[1] == "0.003 (0.000 to 0.010)"


def test_what_is_measured_by_hand_says_so(place):
    place.results("--render")
    assert place.row("cycles") == ["`toolchain/target-cost`, measured by hand 2026-11-22", "2.31 M",
                                   "<= 4 M", "met", "-"]
    assert place.row("lack")[1:4] == ["names Eigen", "fails", "**missed**"]


def test_commands_commit_seeds_and_warning_stand_on_the_page(place):
    place.results("--render")
    page = place.page.read_text()
    assert place.row("recall")[0] == "`kelpie evaluate objects --trials 50 --seed 7000000`"
    assert place.row("error")[0] == "the same"
    assert place.row("fit")[3:] == ["-", "4.7 cm (2005 code)"]
    head = page.split("\n## ")[0]
    for said in ("no proof for a robot", "tools/results --seeds 7,8,9", "abc1234"):
        assert said in head
    assert "| objects | `kelpie evaluate objects --trials 50 --seed 7000000` | 12.5 |" in page


def test_a_missing_key_is_told_in_its_row_and_in_one_line(place):
    place.keep("objects", 8, {k: v for k, v in FIGURES.items() if k != "recall"})
    result = place.results("--render")
    assert result.returncode == 1
    assert problems(result) == ["tools/results: objects: no key 'recall'"]
    assert place.row("recall")[1:4] == ["not measured (no key 'recall')", ">= 0.9", "not measured"]
    assert place.row("fused")[3] == "met"


def test_figures_of_other_trials_are_not_told(place):
    place.keep("objects", 8, FIGURES, trials=49)
    result = place.results("--render")
    assert result.returncode == 1 and place.row("recall")[1] == "not measured (not run yet)"


def test_without_any_figures_the_page_stays(place):
    for path in place.kept.iterdir():
        path.unlink()
    place.page.write_text("before")
    result = place.results("--render")
    assert result.returncode == 2 and place.page.read_text() == "before"
    assert problems(result) == [f"tools/results: {place.kept} holds no figures; measure first: "
                                "tools/results"]


@pytest.mark.parametrize("wrong, said", [
    ('digits = 3, required = ">= 0.9"', "unknown field 'digit'"),
    ('required = ">= 0.9"', "required is a comparison"),
    ('run = "objects"', "no run 'object'")])
def test_a_mistake_in_the_data_file_is_one_line(place, wrong, said):
    change = {"digits": wrong.replace("digits", "digit"), "required": 'required = "about 0.9"',
              "run": 'run = "object"'}[wrong.split()[0]]
    place.data.write_text(DATA.replace(wrong, change, 1))
    result = place.results("--render")
    assert result.returncode == 2 and not place.page.exists()
    assert len(problems(result)) == 1 and said in result.stderr


@pytest.fixture(name="programs")
def programs_that_answer_at_once(tmp_path):
    """KELPIE_BIN with a kelpie that notes its words and writes figures; `distances` fails where a
    file `broken` is beside it."""
    folder = tmp_path / "bin"
    folder.mkdir()
    (folder / "figures").write_text(json.dumps({**FIGURES, "rms_cm": 4.1}))
    for name in ("kelpie-experiments", "kelpie-agent", "kelpie-world", "kelpie"):
        (folder / name).write_text(f"""#!/bin/sh
[ "$1" != --version ] || {{ echo "kelpie 0.1, commit def5678, field lists 0"; exit; }}
echo "$*" >>{folder}/calls
if [ $2 = distances ] && [ -e {folder}/broken ]; then
  echo "kelpie: distances: no data" >&2; exit 1
fi
while [ "$1" != --json ]; do shift; done
cp {folder}/figures "$2"
""")
        (folder / name).chmod(0o755)
    return folder


def test_only_what_is_lacking_is_run(tmp_path, programs):
    place = Place(tmp_path)
    first = place.results(KELPIE_BIN=str(programs))
    calls = (programs / "calls").read_text().splitlines()
    assert first.returncode == 0, first.stderr
    assert [words for words in calls if "objects" in words and "--seed 8000000" in words]
    assert len(calls) == 4 and "objects, seed 9: " in first.stderr and "4 of 4" in first.stderr
    page = place.page.read_text()
    assert "def5678" in page
    (place.kept / "objects-8.json").unlink()
    again = place.results(KELPIE_BIN=str(programs))
    calls = (programs / "calls").read_text().splitlines()[4:]
    assert again.returncode == 0 and len(calls) == 1 and "--seed 8000000" in calls[0]
    last = place.results(KELPIE_BIN=str(programs))
    assert last.stderr == f"tools/results: {place.page}: written\n"


def test_figures_of_another_commit_are_measured_again(place, programs):
    assert place.results(KELPIE_BIN=str(programs)).returncode == 0
    assert len((programs / "calls").read_text().splitlines()) == 4


def test_two_builds_of_a_changed_tree_are_told_apart(tmp_path, programs):
    place = Place(tmp_path)
    kelpie_there = programs / "kelpie"
    kelpie_there.write_text(kelpie_there.read_text().replace("def5678", "def5678-dirty"))
    for calls in (4, 4, 8):
        if calls == 8:
            (programs / "kelpie-experiments").write_text("#!/bin/sh\n# another build\n")
        assert place.results(KELPIE_BIN=str(programs)).returncode == 0
        assert len((programs / "calls").read_text().splitlines()) == calls
    assert re.search(r"commit\ndef5678-dirty-[0-9a-f]{7}\.", place.page.read_text())


def test_an_experiment_that_fails_is_told_and_the_others_stand(tmp_path, programs):
    place = Place(tmp_path)
    (programs / "broken").touch()
    result = place.results(KELPIE_BIN=str(programs))
    assert result.returncode == 1
    assert "tools/results: distances: no data" in result.stderr.splitlines()
    assert place.row("fit")[1] == "not measured (no data)" and place.row("fused")[3] == "met"


def test_chosen_runs_are_told_without_touching_the_page(place):
    result = place.results("--render", "--only", "^dist")
    assert result.returncode == 0 and not place.page.exists()
    assert "| fit |" in result.stdout and "recall" not in result.stdout
    assert place.results("--render", "--only", "nothing").returncode == 2


def test_help_and_wrong_seeds():
    shown = run("--help")
    assert shown.returncode == 0 and shown.stdout.startswith("usage: tools/results ")
    wrong = run("--render", "--seeds", "1,1")
    assert wrong.returncode == 2 and "different whole numbers" in wrong.stderr


def test_every_experiment_is_on_the_page_or_left_out_with_a_reason():
    data = tomllib.loads((ROOT / "tools/experiments/results.toml").read_text())
    listed = kelpie("evaluate", "--list").stdout
    names = set(re.findall(r"^(\S+)", listed, re.M))
    run_names = {run.get("experiment", name) for name, run in data["run"].items()}
    assert len(names) > 20 and names == run_names | set(data["left_out"])
    assert all(reason.strip() for reason in data["left_out"].values())
    told = {row.get("run", subject.get("run")) for subject in data["subject"]
            for row in subject["rows"] if "key" in row}
    assert told == set(data["run"]), "every run is told in some row"
