#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on files, functions, lines and folders over the hard limits of the house style. Exceptions
stand in tools/size_exceptions, one "path reason" a line."""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER_LINES, SOURCE_LINES, FUNCTION_LINES, COLUMNS = 250, 600, 80, 100
FOLDER_SOURCES = 30
FUNCTION_START = re.compile(r"^(?!\s*(?:namespace|class|struct|enum|union|extern)\b)\S.*\{\s*$")


def tracked(*patterns):
    return subprocess.run(["git", "ls-files", *patterns, ":!museum"], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout.split()


def long_functions(lines):
    """Functions at column 0 (clang-format puts their closing brace there too)."""
    start = None
    for number, line in enumerate(lines, 1):
        if start is None and FUNCTION_START.match(line) and "=" not in line.split("(")[0]:
            start = number
        elif line.startswith("}") and start is not None:
            if number - start + 1 > FUNCTION_LINES:
                yield start, number - start + 1
            start = None


def problems_of(path):
    lines = (ROOT / path).read_text().splitlines()
    limit = HEADER_LINES if path.endswith(".h") else SOURCE_LINES
    if len(lines) > limit:
        yield f"{path}: {len(lines)} lines, at most {limit}"
    for number, line in enumerate(lines, 1):
        if len(line) > COLUMNS:
            yield f"{path}:{number}: {len(line)} columns, at most {COLUMNS}"
    if path.endswith((".h", ".cpp")):
        for start, length in long_functions(lines):
            yield f"{path}:{start}: function of {length} lines, at most {FUNCTION_LINES}"


def full_folders(paths):
    for folder, count in Counter(str(Path(path).parent) for path in paths).items():
        if count > FOLDER_SOURCES:
            yield f"{folder}: {count} sources, at most {FOLDER_SOURCES}"


def main():
    exceptions = {line.split()[0] for line in
                  (ROOT / "tools/size_exceptions").read_text().splitlines()
                  if line and not line.startswith("#")}
    sources = tracked("*.h", "*.cpp", "*.py", "*.c")
    found = list(full_folders(sources))
    for path in sources:
        if path not in exceptions:
            found += problems_of(path)
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
