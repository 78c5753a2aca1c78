# SPDX-License-Identifier: Apache-2.0
"""tools/check_changes.py: a word of the command line that comes or goes is named in
CHANGELOG.md."""

import shutil
import subprocess

import pytest
from conftest import ROOT


@pytest.fixture(name="tree")
def a_tree_with_one_option(tmp_path):
    def git(*words):
        subprocess.run(["git", "-C", tmp_path, "-c", "user.name=t", "-c", "user.email=t@t", *words],
                       check=True, capture_output=True)

    (tmp_path / "tools/cli").mkdir(parents=True)
    shutil.copy(ROOT / "tools/check_changes.py", tmp_path / "tools")
    (tmp_path / "CHANGELOG.md").write_text("Options: --old-seed.\n")
    (tmp_path / "tools/cli/Play.cpp").write_text('command.option("--seed", seed, "Where from");\n')
    git("init", "-q")
    git("add", ".")
    git("commit", "-qm", "first")
    git("commit", "-qm", "second", "--allow-empty")
    return tmp_path


def said(tree, source=None, page=None):
    if source is not None:
        (tree / "tools/cli/Play.cpp").write_text(source)
    if page is not None:
        (tree / "CHANGELOG.md").write_text(page)
    done = subprocess.run(["/usr/bin/python3", tree / "tools/check_changes.py"], check=False,
                          capture_output=True, text=True, timeout=60)
    assert (done.returncode == 1) == bool(done.stdout), done.stderr
    return done.stdout


def test_a_tree_without_a_change_is_well_and_so_are_other_words_of_help(tree):
    assert said(tree) == ""
    assert said(tree, 'command.option("--seed", seed, "Where all begins");\n') == ""


def test_an_option_that_comes_is_named(tree):
    both = 'command.option("--seed", seed, "");\ncommand.option("--ball-seed", ball, "");\n'
    assert "does not name --ball-seed" in said(tree, both)
    assert "does not name --ball-seed" in said(tree, page="- `--ball-seeds` is another word.\n")
    assert said(tree, page="- Choose the ball with `--ball-seed`.\n") == ""


def test_an_option_that_goes_is_named(tree):
    assert "does not name --seed" in said(tree, "nothing();\n")  # --old-seed is another


def test_a_subcommand_that_comes_is_named(tree):
    more = 'app.subcommand("sing", "Sings");\ncommand.option("--seed", seed, "");\n'
    assert "does not name sing" in said(tree, more)
    assert said(tree, page="- `kelpie sing`\n") == ""


@pytest.mark.parametrize("path, line, word", [
    ("tools/farm/main.py", "command.add_argument('--fields', default=1)\n", "--fields"),
    ("tools/farm/main.py", "commands.add_parser('harvest')\n", "harvest"),
    ("tools/percepts/main.cpp", 'app.flag("--dim", dim, "");\n', "--dim")])
def test_words_of_the_farm_and_of_the_world_without_pixels_are_looked_at_too(tree, path, line,
                                                                             word):
    (tree / path).parent.mkdir()
    (tree / path).write_text(line)
    subprocess.run(["git", "-C", tree, "add", path], check=True)
    assert f"does not name {word}," in said(tree)
    assert said(tree, page=f"Options: --old-seed, `{word}`.\n") == ""
