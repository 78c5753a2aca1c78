# SPDX-License-Identifier: Apache-2.0
"""Which Kelpie this is: the same line from every program, and a commit that is the tree's."""

import re
import subprocess

from conftest import BIN, ROOT

LINE = re.compile(r"kelpie \d+\.\d+, commit ([0-9a-f]{7,}(-dirty)?|unknown), "
                  r"field lists [0-9a-f]{16}\n")


def git(folder, *words):
    subprocess.run(["git", "-C", folder, "-c", "user.name=t", "-c", "user.email=t@t", *words],
                   check=True, capture_output=True)


def commit_of(folder, out):
    """What the build would compile in for that source tree."""
    subprocess.run(["cmake", "-D", f"OUT={out}", "-D", f"SOURCE={folder}", "-D", "VERSION=3.2",
                    "-P", ROOT / "cmake/commit.cmake"], check=True)
    text = out.read_text()
    assert 'projectVersion() { return "3.2"; }' in text
    return re.search(r'sourceCommit\(\) \{ return "(.*)"; \}', text).group(1)


def test_the_three_programs_say_the_same_line():
    lines = {subprocess.run([BIN / name, "--version"], capture_output=True, text=True, check=True,
                            timeout=20).stdout for name in ("kelpie", "kelpie-agent",
                                                            "kelpie-world")}
    assert len(lines) == 1
    assert LINE.fullmatch(lines.pop())


def test_the_commit_is_the_trees_and_a_change_makes_it_dirty(tmp_path):
    tree = tmp_path / "tree"
    tree.mkdir()
    (tree / "a.txt").write_text("one")
    git(tmp_path, "init", "-q", tree)
    git(tree, "add", "a.txt")
    git(tree, "commit", "-qm", "first")
    git(tree, "tag", "release")  # does not hide the commit
    clean = commit_of(tree, tmp_path / "Commit.cpp")
    assert re.fullmatch("[0-9a-f]{7,}", clean)
    (tree / "new.txt").write_text("no part of the tree yet")
    assert commit_of(tree, tmp_path / "Commit.cpp") == clean
    (tree / "a.txt").write_text("two")
    assert commit_of(tree, tmp_path / "Commit.cpp") == clean + "-dirty"


def test_the_file_is_written_only_when_the_answer_changes(tmp_path):
    out = tmp_path / "Commit.cpp"
    commit_of(tmp_path, out)
    first = out.stat()
    commit_of(tmp_path, out)
    assert (out.stat().st_ino, out.stat().st_mtime_ns) == (first.st_ino, first.st_mtime_ns)
    assert [path.name for path in tmp_path.iterdir()] == ["Commit.cpp"]


def test_a_tree_that_is_no_repository_is_unknown_also_inside_another(tmp_path):
    git(tmp_path, "init", "-q")
    (tmp_path / "kelpie").mkdir()
    assert commit_of(tmp_path / "kelpie", tmp_path / "Commit.cpp") == "unknown"


def test_words_that_nobody_gets_are_no_success():
    with open("/dev/full", "w", encoding="ascii") as full:
        done = subprocess.run([BIN / "kelpie", "--version"], stdout=full, stderr=subprocess.PIPE,
                              text=True, timeout=20)
    assert done.returncode == 3
    assert done.stderr == "kelpie: standard output cannot be written\n"
