#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on an include against the layers or subfolders of docs/architecture.md, on units (a header
with its source file) that include each other in a circle, on Python.h outside behaviour/, on OPEN-R
headers outside robot/, and on tests that include the command line's own files."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BOTTOM = {"robot/core", "robot/body"}
MAY_INCLUDE = {
    "robot/core": {"robot/core"},
    "robot/body": BOTTOM,
    "vision": BOTTOM | {"vision"},
    "gps": BOTTOM | {"gps"},
    "actuator": BOTTOM | {"actuator"},
    "behaviour": BOTTOM | {"behaviour"},
    "robot/openr": BOTTOM | {"robot/openr"},
    "robot/host": BOTTOM | {"robot/openr", "robot/host", "robot/agent", "robot/net"},
    "robot/net": BOTTOM | {"robot/net"},
    "robot/agent": BOTTOM | {"vision", "gps", "actuator", "behaviour", "robot/openr",
                             "robot/agent", "robot/net"},
    "robot/stick": BOTTOM | {"robot/agent", "robot/stick"},
    "robot/object": BOTTOM | {"behaviour", "robot/openr", "robot/agent", "robot/object",
                              "robot/stick"},
}
# The subfolders of a stage in their order: each includes those before it and itself, never its
# neighbours of the same row. What several subfolders share stands at the stage's root.
ROOMS = {
    "vision": [["colour"], ["pixels"], ["blobs"], ["edge"],
               ["ball", "beacon", "goal", "line", "pink", "robot"]],
    "gps": [["pose"], ["camera"], ["ball", "lines"], ["pinks", "players"]],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)


def folder_of(path):
    parts = Path(path).parts
    return "/".join(parts[:2]) if parts[0] == "robot" else parts[0]


def includes(path):
    return [name for _, name in INCLUDE.findall((ROOT / path).read_text())]


def room_of(path):
    """(stage, room, rank), or None for what is in no room."""
    parts = Path(path).parts
    for rank, row in enumerate(ROOMS.get(parts[0], ())):
        if parts[1] in row:
            return parts[0], parts[1], rank
    return None


def wrong_room(path, name):
    mine, other = room_of(path), room_of(name)
    if mine and other and mine[0] == other[0] and mine[1] != other[1] and mine[2] <= other[2]:
        return f"subfolder {mine[0]}/{mine[1]} may not include {other[0]}/{other[1]}"
    return None


def wrong_include(path, name):
    layer = folder_of(path)
    # Fuzz targets are built of files, the command line's among them, and of no library.
    if (path.startswith("tests/") and not path.startswith("tests/fuzz/")
            and name.startswith("tools/cli/")):
        return "tests include what they share with the command line from a library, not from it"
    if name == "Python.h" and layer not in ("behaviour", "tests", "toolchain"):
        return "Python.h belongs to behaviour/ only"
    if name.startswith("OPENR/") and not path.startswith(("robot/", "tests/")):
        return "OPEN-R headers belong to robot/ only"
    if layer in MAY_INCLUDE and (ROOT / name).exists():
        if folder_of(name) not in MAY_INCLUDE[layer]:
            return f"{layer} may not include {folder_of(name)}"
    return wrong_room(path, name)


def unit_of(path):
    """A header and its source file are one unit: together they say what a part needs."""
    return str(Path(path).with_suffix(""))


def circles_of(graph):
    """The sets of units that include each other in a circle (Tarjan's strongly connected parts)."""
    number, low, stack, circles = {}, {}, [], []

    def visit(unit):
        number[unit] = low[unit] = len(number)
        stack.append(unit)
        for other in graph.get(unit, ()):
            if other not in number:
                visit(other)
            if other in stack:
                low[unit] = min(low[unit], low[other])
        if low[unit] == number[unit]:
            part = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(part) > 1:
                circles.append(sorted(part))

    for unit in sorted(graph):
        if unit not in number:
            visit(unit)
    return circles


def main():
    files = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split()
    graph = {}
    for path in files:
        needed = {unit_of(name) for name in includes(path) if (ROOT / name).exists()}
        graph.setdefault(unit_of(path), set()).update(needed - {unit_of(path)})
    problems = [f"{path}: {why} ({name})" for path in files for name in includes(path)
                if (why := wrong_include(path, name))]
    problems += ["units include each other: " + ", ".join(circle) for circle in circles_of(graph)]
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
