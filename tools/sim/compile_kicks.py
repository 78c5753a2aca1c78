#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the kick map of the behaviours as C++: compile_kicks.py pycode/lib/kick_map.py OUT.cpp

What each row means is told in kick_map.py and tools/sim/KickTable.h."""

import re
import sys
import types
from pathlib import Path

HEAD = """// Written by tools/sim/compile_kicks.py.
#include "tools/sim/KickTable.h"

namespace kelpie::sim {
"""


class Names(types.ModuleType):
    """Stands for the module kelpie: KICK_FORWARD is MotionKind::kickForward."""

    def __getattr__(self, name):
        first, *others = name.lower().split("_")
        return "MotionKind::" + first + "".join(word.capitalize() for word in others)


def read(path):
    sys.modules["kelpie"] = Names("kelpie")
    found = {}
    exec(compile(path.read_text(), str(path), "exec"), found)
    return found


def even(numbers):
    """The step between the places of a row."""
    steps = {b - a for a, b in zip(numbers, numbers[1:])}
    if len(steps) != 1:
        raise SystemExit(f"kick map: uneven places {numbers}")
    return steps.pop()


def cell(outcome):
    """One with a robot's body in the way is of no ball."""
    return "{" + ", ".join(str(number) for number in (outcome or (0,) * 6)[:5]) + "}"


def grid(motion, walks, data):
    ahead, aside = data["ahead"], data["aside"]
    cells = ",\n     ".join(cell(place) for row in data["places"] for place in row)
    return (f"    {{{motion}, {str(walks).lower()}, {aside[0]}, {even(aside)}, {len(aside)}, "
            f"{ahead[0]}, {even(ahead)}, {len(ahead)},\n     {{{cells}}}}}")


def text(found):
    grids = [grid(motion, walks, data) for name, walks in (("STANDING", False), ("WALKING", True))
             for motion, data in found[name].items()]
    held = [f"    {{{motion}, {cell(data['whole'])}}}" for motion, data in found["HELD"].items()]
    return (HEAD + "\nconst std::vector<KickGrid>& kickGrids() {\n"
            "  static const std::vector<KickGrid> all{\n" + ",\n".join(grids) +
            "};\n  return all;\n}\n\nconst std::vector<HeldKick>& heldKicks() {\n"
            "  static const std::vector<HeldKick> all{\n" + ",\n".join(held) +
            "};\n  return all;\n}\n\n}  // namespace kelpie::sim\n")


if __name__ == "__main__":
    Path(sys.argv[2]).write_text(re.sub(r"\n{3,}", "\n\n", text(read(Path(sys.argv[1])))))
