# SPDX-License-Identifier: Apache-2.0
"""Which Kelpie this is: the same line from every program, and a commit that is the tree's."""

import re
import subprocess

from conftest import BIN, ROOT

LINE = re.compile(r"kelpie \d+\.\d+\S*, commit ([0-9a-f]{7,}(-dirty)?|unknown), "
                  r"field lists [0-9a-f]{16}\n")


def git(folder, *words):
    subprocess.run(["git", "-C", folder, "-c", "user.name=t", "-c", "user.email=t@t", *words],
                   check=True, capture_output=True)


def commit_of(folder, out):
    """What the build would compile in for that source tree."""
    subprocess.run(["cmake", "-D", f"OUT={out}", "-D", f"SOURCE={folder}", "-D", "VERSION=3.2",
                    "-P", ROOT / "cmake/commit.cmake"], check=True)
    return re.search(r'sourceCommit\(\) \{ return "(.*)"; \}', out.read_text()).group(1)


def version_of(folder, out):
    commit_of(folder, out)
    return re.search(r'projectVersion\(\) \{ return "(.*)"; \}', out.read_text()).group(1)


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


def test_the_version_is_the_last_tag_and_before_one_it_sorts_before_the_next(tmp_path):
    tree, out = tmp_path / "tree", tmp_path / "Commit.cpp"
    assert version_of(tmp_path, out) == "3.2~unknown"
    git(tmp_path, "init", "-q", tree)
    git(tree, "commit", "-q", "--allow-empty", "-m", "first")
    assert re.fullmatch(r"3\.2~\d{8}\.g[0-9a-f]{7}", version_of(tree, out))
    git(tree, "tag", "v3.3")
    assert version_of(tree, out) == "3.3"
    git(tree, "commit", "-q", "--allow-empty", "-m", "second")
    assert re.fullmatch(r"3\.3\+1\.g[0-9a-f]{7}", version_of(tree, out))


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
