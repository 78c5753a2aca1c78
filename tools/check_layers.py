#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on an include against the layers of docs/architecture.md, on an include cycle, on Python.h
outside behaviour/ and on OPEN-R headers outside robot/."""

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
    "robot/host": BOTTOM | {"robot/openr", "robot/host", "robot/agent"},
    "robot/net": BOTTOM | {"robot/net"},
    "robot/agent": BOTTOM | {"vision", "gps", "actuator", "behaviour", "robot/openr",
                             "robot/agent", "robot/net"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)


def folder_of(path):
    parts = Path(path).parts
    return "/".join(parts[:2]) if parts[0] == "robot" else parts[0]


def includes(path):
    return [name for _, name in INCLUDE.findall((ROOT / path).read_text())]


def wrong_include(path, name):
    layer = folder_of(path)
    if name == "Python.h" and layer not in ("behaviour", "tests", "toolchain"):
        return "Python.h belongs to behaviour/ only"
    if name.startswith("OPENR/") and not path.startswith(("robot/", "tests/")):
        return "OPEN-R headers belong to robot/ only"
    if layer in MAY_INCLUDE and (ROOT / name).exists():
        if folder_of(name) not in MAY_INCLUDE[layer]:
            return f"{layer} may not include {folder_of(name)}"
    return None


def find_cycle(graph):
    done, trail = set(), []

    def visit(node):
        if node in trail:
            return trail[trail.index(node):] + [node]
        if node in done:
            return None
        trail.append(node)
        for child in graph.get(node, ()):
            cycle = visit(child)
            if cycle:
                return cycle
        trail.pop()
        done.add(node)
        return None

    for node in graph:
        cycle = visit(node)
        if cycle:
            return cycle
    return None


def main():
    files = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split()
    graph = {path: [n for n in includes(path) if (ROOT / n).exists()] for path in files}
    problems = [f"{path}: {why} ({name})" for path in files for name in includes(path)
                if (why := wrong_include(path, name))]
    cycle = find_cycle(graph)
    if cycle:
        problems.append("include cycle: " + " -> ".join(cycle))
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
