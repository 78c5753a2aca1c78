#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""constants.py CONSTANTS.toml OUT.h writes the constants of the behaviours as a struct of
parameters, so that files, logs, the stick and `world` treat them as all other parameters; a file
that would stay the same is not touched. Exit code 2: a constant that says too little of itself, or
contradicts itself."""

import re
import sys
import tomllib
from pathlib import Path
from typing import NamedTuple

KEYS = {"default", "range", "unit", "what"}
NAME = re.compile(r"[a-z][A-Za-z0-9]*")
UNITS = ("", "cm", "cm/s", "s", "deg", "deg/s")
HEAD = """// SPDX-License-Identifier: Apache-2.0
// Written by behaviour/constants.py from behaviour/constants.toml.
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie::behaviour {
"""


class Wrong(Exception):
    pass


class Constant(NamedTuple):
    group: str
    name: str
    default: float     # an int: a count
    low: float
    high: float
    unit: str
    what: str

    @property
    def key(self):
        """Of the parameter."""
        return f"behaviour.constants.{self.group}.{self.name}"

    @property
    def counts(self):
        return isinstance(self.default, int)

    def value(self, number):
        """As a parameter file writes it."""
        number = round(number) if self.counts else float(number)
        return f'"{number}{self.unit}"' if self.unit else str(number)


def is_number(value):
    return type(value) in (int, float)


def constant(group, name, said):
    place = f"{group}.{name}"
    if not NAME.fullmatch(group) or not NAME.fullmatch(name):
        raise Wrong(f"{place}: is no name such as carryTo")
    if not isinstance(said, dict) or set(said) != KEYS:
        raise Wrong(f"{place}: says default, range, unit and what, and nothing else")
    default, limits = said["default"], said["range"]
    if not isinstance(limits, list) or len(limits) != 2 or not all(map(is_number, limits)):
        raise Wrong(f"{place}.range: is two numbers, [low, high]")
    if not is_number(default) or not limits[0] <= default <= limits[1] or limits[0] == limits[1]:
        raise Wrong(f"{place}.default: is a number of the range")
    if isinstance(default, int) and not all(isinstance(limit, int) for limit in limits):
        raise Wrong(f"{place}.range: of a count, is two counts")
    if said["unit"] not in UNITS:
        raise Wrong(f"{place}.unit: is one of {', '.join(UNITS[1:])}, or empty")
    if not isinstance(said["what"], str) or len(said["what"].split()) < 3:
        raise Wrong(f"{place}.what: says what the constant does")
    return Constant(group, name, default, *limits, said["unit"], said["what"])


def constants(path):
    """The vector, in the order of the file."""
    try:
        table = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Wrong(f"{path}: {error}") from None
    found = []
    for group, rows in table.items():
        if not isinstance(rows, dict):
            raise Wrong(f"{path}: {group}: a constant stands in a group")
        try:
            found += [constant(group, name, said) for name, said in rows.items()]
        except Wrong as wrong:
            raise Wrong(f"{path}: {wrong}") from None
    if not found:
        raise Wrong(f"{path}: no constant")
    return found


# --- C++ -----------------------------------------------------------------------------------------

def type_name(group):
    return group[0].upper() + group[1:] + "Constants"


def groups(found):
    of = {}
    for one in found:
        of.setdefault(one.group, []).append(one)
    return of


def listed(type_of, rows):
    """The field list of a struct."""
    yield "  template <int = 0>"
    yield "  static constexpr auto fields() {"
    yield f"    using T = {type_of};"
    yield "    return fieldList("
    yield ",\n".join(f"        {row}" for row in rows) + ");"
    yield "  }"
    yield "};"
    yield ""


def group_text(group, rows):
    yield f"struct {type_name(group)} {{"
    for one in rows:
        kind = "std::uint32_t" if one.counts else "double"
        yield f"  // {one.what}"
        yield f"  {kind} {one.name} = {one.default};"
    yield ""
    yield from listed(type_name(group), [
        f'field("{one.name}", &T::{one.name}, "{one.unit}", {one.low}, {one.high})'
        for one in rows])


def header(found):
    of = groups(found)
    yield HEAD
    for group, rows in of.items():
        yield from group_text(group, rows)
    yield "struct Constants {"
    yield from (f"  {type_name(group)} {group};" for group in of)
    yield ""
    yield from listed("Constants", [f'field("{group}", &T::{group})' for group in of])
    yield "}  // namespace kelpie::behaviour"


def write(path, text):
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        write(Path(sys.argv[2]), "\n".join(header(constants(sys.argv[1]))) + "\n")
    except Wrong as wrong:
        print(f"constants.py: {wrong}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
