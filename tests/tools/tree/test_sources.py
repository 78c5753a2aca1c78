# SPDX-License-Identifier: Apache-2.0
"""tools/check_sources.py: docs/sources.md holds every citation, and every line there is cited."""

import shutil
import subprocess

import pytest
from conftest import ROOT

SOURCES = """# Sources

| document | what it is |
|---|---|
| facts-2005 | numbers |

| id | what it says | origin |
|---|---|---|
| data/robot | sizes | 2005 |
| facts-2005 4.5 check 7 | 20 px | code |
| openr.md 5.6 | ranges | documents |
| checklist H04 | a sign | thesis 2004 |
| checklist H05 | an order | thesis 2004 |
| checklist A-2.3.2.6 | numbers | thesis 2006 |
| thesis 2004 section 2.1.2 | weights | page 10 |
| thesis 2004 section 2.1.3 | a factor | page 12 |
| thesis 2004 section 2.1.4 | a sum | page 14 |
| thesis 2004 figure 2.10 | a table | page 22 |
| thesis 2006 equation 2.2 | a polynomial | page 14 |
"""
GOOD = """// Limits (openr.md 5.6) and signs as in checklist H04 and H05; (thesis 2004 sections
// 2.1.2 to 2.1.4, figure 2.10).
int x = 20;  // px, facts-2005 section 4.5
             // check 7
"""
GOOD_MD = """The model (thesis 2006 equation 2.2, checklist A-2.3.2.6), ranges of `openr.md` 5.6,
`data/robot/*.csv`.
"""


def git(tree, *words):
    subprocess.run(["git", *words], cwd=tree, check=True, capture_output=True)


@pytest.fixture(name="check")
def check_in_a_tree(tmp_path):
    """The checker in a repository of its own with these citations and this line more."""
    def check(line="", sources=SOURCES):
        for folder in ("tools", "docs"):
            (tmp_path / folder).mkdir()
        shutil.copy(ROOT / "tools/check_sources.py", tmp_path / "tools")
        (tmp_path / "docs/sources.md").write_text(sources)
        (tmp_path / "good.h").write_text(GOOD)
        (tmp_path / "README.md").write_text(GOOD_MD)
        (tmp_path / "more.py").write_text("# one\n" + line + "\n")
        git(tmp_path, "init", "-q")
        git(tmp_path, "add", ".")
        return subprocess.run(["/usr/bin/python3", tmp_path / "tools/check_sources.py"],
                              capture_output=True, text=True, timeout=60, check=False)
    return check


def test_all_citations_of_this_tree_are_held():
    result = subprocess.run(["/usr/bin/python3", ROOT / "tools/check_sources.py"], timeout=60,
                            capture_output=True, text=True, check=False)
    assert (result.returncode, result.stdout) == (0, "")


def test_citations_are_found_in_lists_ranges_and_over_the_end_of_a_line(check):
    result = check("# as the thesis says; 2004 was a year, and 17 of 20 scored (H04)")
    assert (result.returncode, result.stdout) == (0, "")


@pytest.mark.parametrize("line, missing", [
    ("# facts-2005 section 4.6", "facts-2005 4.6"),
    ("# thesis 2004 section 2.1.2 and 2.1.5", "thesis 2004 section 2.1.5"),
    ("# Thesis 2006 2.1.2", "thesis 2006 section 2.1.2"),
    ("# (2004 Fig 2.9)", "thesis 2004 figure 2.9"),
    ("# checklist H04..H06", "checklist H06"),
    ("# as in U12", "checklist U12"),
    ("# ../shared/data/walk/sets.csv, tests/tools/data/a.png", "data/walk"),
    ("# spec `openr-measured.md` section 3", "openr-measured.md 3")])
def test_a_false_citation_is_refused_with_its_line(check, line, missing):
    result = check(line)
    assert result.returncode == 1
    assert result.stdout == f"more.py:2: {missing} is not in docs/sources.md\n"


@pytest.mark.parametrize("line, said", [("# numbers of facts-2005", "facts-2005"),
                                        ("# see the checklist", "checklist")])
def test_a_document_without_a_place_in_it_is_refused(check, line, said):
    result = check(line)
    assert result.returncode == 1
    assert result.stdout == f"more.py:2: {said}: say which section or row\n"


def test_a_line_that_nothing_cites_is_refused(check):
    result = check(sources=SOURCES + "| checklist M30 | more | thesis 2006 |\n")
    assert result.returncode == 1
    assert result.stdout == "docs/sources.md:20: nothing cites checklist M30\n"
