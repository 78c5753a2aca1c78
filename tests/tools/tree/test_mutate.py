# SPDX-License-Identifier: Apache-2.0
"""Which changes tools/mutate makes of a file, and that a seed draws the same ones again."""

import ast
import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "tools"))

from mutation.coverage_map import CoverageMap, read_map  # noqa: E402
from mutation.mutants import Mutant, mutants_of  # noqa: E402

SOURCE = '''\
"""Says 12."""
FAR = 2.5      # cm
SIDES = -1, 1


def near(ball: int = 3) -> bool:
    """Whether it is < 4."""
    if ball < FAR and not lost(ball):
        return f'{ball:.1f}' == ball + 1
    return True if ball in SIDES else False
'''


def changes(kind):
    return {(m.before, m.after) for m in mutants_of("a.py", SOURCE) if m.kind == kind}


def test_numbers_become_others_but_not_those_in_texts():
    assert changes("number") == {("2.5", "5.0"), ("2.5", "1.25"), ("2.5", "0.0"), ("1", "2"),
                                 ("1", "0"), ("3", "6"), ("3", "0")}


def test_comparisons_are_turned_round():
    assert ("ball < FAR", "ball >= FAR") in changes("comparison")
    assert ("ball in SIDES", "ball not in SIDES") in changes("comparison")


def test_signs_logic_and_branches_are_changed():
    assert ("ball + 1", "(ball - 1)") in changes("sign") and ("-1", "(1)") in changes("sign")
    assert ("not lost(ball)", "(lost(ball))") in changes("logic")
    assert ("ball < FAR and (not lost(ball))".replace("(not lost(ball))", "not lost(ball)"),
            "(ball < FAR or not lost(ball))") in changes("logic")
    assert any(after.startswith("(False if") for _, after in changes("branch"))


def test_every_change_is_python_and_changes_what_it_says():
    for mutant in mutants_of("a.py", SOURCE):
        changed = mutant.applied(SOURCE)
        assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse(SOURCE)), mutant.id
        assert SOURCE[mutant.start:mutant.end] == mutant.before


def test_a_change_of_a_module_level_number_knows_its_name():
    assert {m.name for m in mutants_of("a.py", SOURCE) if m.before == "2.5"} == {"FAR"}


@pytest.mark.parametrize("readers, tests", [
    ([("a.py", 5)], {"near"}), ([("a.py", 5), ("b.py", 7)], {"near", "far"}),
    ([("a.py", 5), ("b.py", 1)], set()), ([], set())])
def test_who_reads_a_constant_may_notice_it_and_as_a_module_is_loaded_everybody(readers, tests):
    where = CoverageMap.__new__(CoverageMap)
    where.lines = {"a.py": {"5": ["near"]}, "b.py": {"7": ["far"]}}
    where.readers = {"FAR": readers}
    assert where.tests_of(Mutant("a.py", 2, "number", "2.5", "0.0", 0, 3, "FAR")) == tests


def listed(*words):
    result = subprocess.run([ROOT / "tools/mutate", "--list", *words], capture_output=True,
                            text=True, check=False, timeout=60)
    assert result.returncode == 0, result.stderr
    return result.stdout.splitlines()


def test_a_seed_draws_the_same_changes_again():
    first = listed("--seed", "5", "--n", "20")
    assert len(first) == 20 and first == listed("--seed", "5", "--n", "20")
    assert first != listed("--seed", "6", "--n", "20")
    assert all(line.split("/")[0] in ("players", "roles", "decisions", "skills") for line in first)


@pytest.mark.parametrize("words", (["--files", "nobody/*"], ["--only", "no such line"]))
def test_no_change_is_a_complaint(words):
    result = subprocess.run([ROOT / "tools/mutate", "--list", *words], capture_output=True,
                            text=True, check=False, timeout=60)
    assert result.returncode == 2 and result.stderr == "mutate: there is no such change\n"


@pytest.mark.parametrize("words, says", [
    (["--n", "0"], "argument --n: "), (["--n", "-3"], "argument --n: "),
    (["--jobs", "0"], "argument --jobs: "), (["--least", "2"], "argument --least: "),
    (["--only", "nowhere.py:1"], "there is no such change"),
    (["--json", "nowhere/of.json", "--list"], "nowhere/of.json: cannot be written")])
def test_wrong_use_ends_with_one_clear_line_and_code_2_before_any_test_runs(words, says):
    result = subprocess.run([sys.executable, ROOT / "tools/mutate", *words], check=False,
                            capture_output=True, text=True, cwd=ROOT, timeout=60)
    assert result.returncode == 2 and says in result.stderr.splitlines()[-1]


@pytest.mark.parametrize("text", ["", '{"digest": "1', "[]"])
def test_a_damaged_map_of_coverage_is_made_anew(tmp_path, text):
    (tmp_path / "map.json").write_text(text)
    assert read_map(tmp_path / "map.json") == {}
    assert read_map(tmp_path / "none.json") == {}
