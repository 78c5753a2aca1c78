# SPDX-License-Identifier: Apache-2.0
"""tools/check_house.py: what it refuses in pages."""

import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "tools"))
import check_house  # noqa: E402

WIDE = "word " * 25
HASHES = "ab47909 7622dba 6f1a421 dfd83d6 aef54c6 b61585b".split()


def problems(text, path="docs/page.md"):
    return list(check_house.page_problems(path, text))


def test_prose_of_a_page_is_not_wider_than_other_files():
    assert problems(WIDE + "\n") == ["docs/page.md:1: prose of 125 columns, at most 100"]
    assert problems("word " * 20 + "\n") == []


@pytest.mark.parametrize("text", [
    f"| {WIDE} | {WIDE} |", f"```\n{WIDE}\n```", f"    {WIDE}", f"- [{WIDE}](docs/there.md)",
    "x" * 120])
def test_a_line_that_has_no_place_to_break_may_be_wide(text):
    assert problems(text + "\n") == []


def test_prose_behind_a_block_of_code_is_prose_again():
    assert problems(f"```\n{WIDE}\n```\n{WIDE}\n") == [
        "docs/page.md:4: prose of 125 columns, at most 100"]


def test_a_page_that_is_excepted_or_generated_may_be_wide():
    assert list(check_house.page_problems("a/README.md", WIDE, {"a/README.md"})) == []
    assert problems(WIDE, "docs/results.md") == []


@pytest.mark.parametrize("text", ["by a program that is not in the tree", "one not in\nthe tree"])
def test_a_figure_that_nobody_can_repeat_is_refused(text):
    (found,) = problems("# A page\n" + text + "\n", "docs/decisions.md")
    assert found.startswith("docs/decisions.md:2: 'not in")


def test_more_than_five_commit_hashes_in_all_pages_are_refused():
    pages = {"docs/a.md": " ".join(HASHES[:3]), "docs/b.md": " ".join(HASHES[3:5])}
    assert check_house.pages_problems(pages) == []
    pages["b/README.md"] = f"| since {HASHES[5]} |"
    found = check_house.pages_problems(pages)
    assert len(found) == 6 and found[0].startswith("docs/a.md:1: ab47909: a commit's hash")


def test_records_name_the_commits_of_their_figures():
    text = " ".join(HASHES)
    assert check_house.pages_problems({"docs/results.md": text, "docs/decisions.md": text}) == []


def test_what_a_program_prints_and_what_is_a_number_or_a_word_is_no_hash():
    text = f"```\n{' '.join(HASHES)}\n```\nseed 301000000, a facade, decaded, 1234567\n"
    assert check_house.pages_problems({"docs/a.md": text * 3}) == []


def test_the_pages_of_the_tree_are_within_the_rules():
    pages = {path: (ROOT / path).read_text() for path in check_house.tracked("*.md")}
    assert "docs/architecture.md" in pages
    assert check_house.pages_problems(pages, check_house.excepted_pages()) == []
