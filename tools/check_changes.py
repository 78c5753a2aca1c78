#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an option or a subcommand of the command line has come or gone since origin/main (on
main itself: since the commit before) and CHANGELOG.md does not name it. Words of the command line
alone are looked at, since every one of them is a user's to type; whatever else a user can see is
the author's to write down."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PLACES = ("tools/cli", "tools/sim/main.cpp", "tools/experiments/harness", "tools/percepts/main.cpp",
          "tools/farm/main.py")
# As the programs in C++ declare them, and as the farm's, which is in Python.
WORD = (r"""["']!?--[a-z][a-z0-9-]*|subcommand\("[a-z][a-z-]*"|add_parser\(["'][a-z][a-z-]*["']""")


def git(root, *words):
    return subprocess.run(["git", "-C", root, *words], check=False, capture_output=True,
                          text=True).stdout.strip()


def base_of(root):
    """As tools/check has it for clang-tidy; empty for a first commit."""
    base = git(root, "merge-base", "HEAD", "origin/main")
    if not base or base == git(root, "rev-parse", "HEAD"):
        base = git(root, "rev-parse", "-q", "--verify", "HEAD~1")
    return base


def words(root, commit=None):
    """What can be typed, as the sources of a commit say it, or those of the working tree."""
    found = git(root, "grep", "-hoE", WORD, *([commit] if commit else []), "--", *PLACES)
    return {re.split("[\"']", line)[1].lstrip("!") for line in found.splitlines()}


def unnamed(root):
    base = base_of(root)
    if not base:
        return []
    changed = words(root) ^ words(root, base)
    page = Path(root) / "CHANGELOG.md"
    text = page.read_text() if page.is_file() else ""
    return sorted(word for word in changed
                  if not re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text))


def main():
    found = unnamed(ROOT)
    for word in found:
        print(f"CHANGELOG.md: does not name {word}, which has come or gone: what can people do now "
              "that they could not before?")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
