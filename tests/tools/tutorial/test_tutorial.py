# SPDX-License-Identifier: Apache-2.0
"""docs/first-behaviour.md does what it says, and tools/tutorial says in one line where a page does
not."""

import subprocess

import pytest
from conftest import BIN, ROOT


def tutorial(*words, timeout=600):
    return subprocess.run([ROOT / "tools/tutorial", "--kelpie", BIN, *map(str, words)],
                          capture_output=True, text=True, timeout=timeout, check=False)


def test_the_commands_of_the_tutorial_run_and_print_what_the_page_says():
    done = tutorial()
    assert done.returncode == 0, done.stderr + done.stdout[-2000:]
    assert "$ kelpie new-team foxes" in done.stdout


PAGES = {
    "says": ("<!-- run -->\n```\n$ echo one\ntwo\n```\n", ":4: says 'two', prints 'one'"),
    "more": ("<!-- run -->\n```\n$ printf 'a\\nb\\n'\na\n```\n", ":3: prints 'b', too"),
    "fails": ("<!-- run -->\n```\n$ echo why; false\n```\n", ":3: exit code 1: why"),
    "few": ("<!-- run, at least 3 -->\n```\n$ echo 9: 2\n```\n", ":1: prints 2, not at least 3"),
    "bound": ("<!-- run, about 3 -->\n```\n$ echo 2\n```\n", ":1: 'about 3' is not"),
    "silent": ("<!-- run, at most 3 -->\n```\n$ true\n```\n", ":1: no figure is printed"),
    "no block": ("<!-- run -->\n\n```\n$ true\n```\n", ":1: no block follows"),
    "no end": ("<!-- run -->\n```\n$ true\n", ":2: the block has no end"),
    "no command": ("<!-- run -->\n```\nls\n```\n", ":3: the block does not begin with a command"),
    "no line": ("<!-- in a.py for x -->\n```\ny\n```\n", ":1: 'x' stands in 0 lines of a.py"),
    "comment": ("<!-- play -->\n", ":1: no comment of tools/tutorial"),
    "nothing": ("# A page\n", ":1: nothing to do"),
    "no name": ("<!-- file -->\n```\nx\n```\n", ":1: 'file' with ''"),
    "no place": ("<!-- in a.py -->\n```\nx\n```\n", ":1: 'in' with 'a.py'"),
    "no target": ("<!-- picture a.png -->\n", ":1: 'picture' with 'a.png'"),
    "out": ("<!-- file ../a.py -->\n```\nx\n```\n", ":1: ../a.py leads out of the folder"),
    "root": ("<!-- in /a.py for x -->\n```\nx\n```\n", ":1: /a.py leads out of the folder"),
    "empty": ("<!-- run -->\n```\n```\n", ":1: the block is empty"),
    "hears": ("<!-- run -->\n```\n$ read x\n```\n", ":3: exit code 1: nothing printed"),
    "picture": ("<!-- picture a.png docs/a.png -->\n", ":1: no picture a.png"),
}


@pytest.mark.parametrize("name", PAGES)
def test_a_page_that_does_not_hold_is_refused_with_the_line_of_the_page(name, tmp_path):
    text, line = PAGES[name]
    page = tmp_path / "page.md"
    page.write_text(text)
    done = tutorial(page)
    assert done.returncode == 1
    assert done.stderr.startswith("tools/tutorial: ") and done.stderr.count("\n") == 1
    assert line in done.stderr, done.stderr


def test_files_edits_and_what_may_be_anything_are_understood(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("<!-- file a/x.py -->\n```python\nprint(1)\nprint(2)\n```\n"
                    "<!-- in a/x.py for print(2) -->\n```python\nprint(3)\nprint(40)\n```\n"
                    "<!-- run, at least 40 -->\n```\n$ for i in 1; do\n> python3 a/x.py; done\n"
                    "1\n...\n4...\n```\n")
    done = tutorial(page)
    assert done.returncode == 0, done.stderr


def test_a_page_and_programs_that_are_not_there_are_named(tmp_path):
    done = tutorial(tmp_path / "none.md")
    assert done.returncode == 1 and "none.md" in done.stderr and done.stderr.count("\n") == 1
    done = subprocess.run([ROOT / "tools/tutorial", "--kelpie", tmp_path], capture_output=True,
                          text=True, timeout=60, check=False)
    assert done.returncode == 1
    assert done.stderr == (f"tools/tutorial: no kelpie in {tmp_path}: tools/build host kelpie, "
                           "or --kelpie DIR\n")
