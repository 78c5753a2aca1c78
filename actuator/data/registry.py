#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The one list of the special motions and of the choices that behaviours know by name.

registry.py MOTIONS ENUMERATIONS.toml OUT makes OUT/robot/core/Enumerations.h,
OUT/actuator/MotionList.h and OUT/behaviour/PythonEnumerations.h of them, and touches none that
would stay the same. A motion
is listed by its own file: MOTIONS/NAME.toml has `motion = { number, use, ball, leaf, hint, key }`
(actuator/README.md tells these). A file that does not say so is refused, as is a number that two
have or none."""

import sys
import textwrap
import tomllib
from pathlib import Path

USES = ("rest", "kick", "block", "grab", "hold", "get_up", "show")
BALLS = ("", "free", "held", "both")
KEYS = {"number", "use", "ball", "leaf", "hint", "key"}
LEARN_KEYS = {"scatter", "distance", "min", "max", "frames"}
HEAD = ("// SPDX-License-Identifier: Apache-2.0\n"
        "// Written by actuator/data/registry.py from actuator/data/motions and "
        "enumerations.toml.\n")


class Wrong(Exception):
    pass


def read(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


class Motion:
    """A listed motion. The right one of a pair has what its left one says, sides exchanged."""

    def __init__(self, path):
        self.name, table = path.stem, read(path)
        listed = table.get("motion")
        if not isinstance(listed, dict) or "number" not in listed:
            raise Wrong(f"{path}: motion: says nothing of its number (actuator/README.md)")
        other = table.get("mirror")
        of = read(path.with_name(other + ".toml")) if other else table
        pair = of.get("motion", {})
        self.number, self.mirror = listed["number"], other or self.name
        self.use, self.ball = pair.get("use"), pair.get("ball", "")
        self.leaf = listed.get("leaf", "")
        # `key = "6 leg left"`: the key of teleop and the word beside it.
        self.key, _, self.word = listed.get("key", "").partition(" ")
        side = -1 if other else 1
        hint = pair.get("hint")
        self.hint = hint and (float(hint[0]), float(side * hint[1]))
        kick = of.get("kick", {})
        self.place = float(kick.get("ahead", 0)), float(side * kick.get("left", 0))
        self.distance = float(kick.get("distance", 0))
        self.learn = None if other else table.get("learn")
        self.lines = [f"{word} = {inline(table[word])}" for word in ("motion", "learn")
                      if word in table]
        self.check(path, listed)

    def check(self, path, listed):
        for key in set(listed) - KEYS:
            raise Wrong(f"{path}: motion.{key}: there is no such key")
        for key in set(self.learn or {}) - LEARN_KEYS:
            raise Wrong(f"{path}: learn.{key}: there is no such key")
        if self.use not in USES:
            raise Wrong(f"{path}: motion.use: is one of {', '.join(USES)}")
        if self.ball not in BALLS or (self.ball == "") != (self.use != "kick"):
            raise Wrong(f"{path}: motion.ball: a kick's is free, held or both")
        if len(self.key) > 1 or bool(self.key) != bool(self.word):
            raise Wrong(f'{path}: motion.key: is a letter and a word, such as "6 leg left"')


def inline(table):
    def text(value):
        if isinstance(value, str):
            return f'"{value}"'
        return "[" + ", ".join(map(str, value)) + "]" if isinstance(value, list) else str(value)
    return "{ " + ", ".join(f"{key} = {text(value)}" for key, value in table.items()) + " }"


def motions(folder):
    """All motions in the order of their numbers, from 1 without a gap."""
    found = sorted((Motion(path) for path in folder.glob("*.toml")), key=lambda one: one.number)
    for number, motion in enumerate(found, 1):
        if motion.number != number:
            raise Wrong(f"{folder / motion.name}.toml: motion.number: {motion.number}, where "
                        f"{number} is the next")
    keys = [motion.key for motion in found if motion.key]
    for key in keys:
        if keys.count(key) > 1:
            raise Wrong(f"{folder}: motion.key: two have {key}")
    return found


def pairs(found):
    """{name: the name of its mirror image}, in both directions."""
    of = {motion.name: motion.mirror for motion in found}
    return {**of, **{other: name for name, other in of.items() if name != other}}


def camel(name):
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def python_name(name):
    return "NO_MOTION" if name == "none" else name.upper()


# --- C++ -----------------------------------------------------------------------------------------

def enumeration(name, about, values):
    """With its count, and the names of its values as C++ has them."""
    yield from ("// " + line for line in textwrap.wrap(about, 96))
    yield f"enum class {name} : std::uint8_t {{ {', '.join(values)} }};"
    yield f"constexpr std::uint8_t k{name}Count = {len(values)};"
    names = ", ".join(f'"{value}"' for value in values)
    yield f"constexpr std::array<const char*, k{name}Count> k{name}Names{{{names}}};"
    yield ""


def flag(value):
    return "true" if value else "false"


def listed(found):
    """The rows of MotionList.h."""
    yield '    {"none", "no motion", MotionKind::none, false, false, 0, {}, ""},'
    other = pairs(found)
    for motion in found:
        learn = motion.learn or {}
        wish = ", ".join(str(float(learn.get(key, default))) for key, default in
                         (("scatter", 1.2), ("distance", 0), ("min", 0), ("max", 0),
                          ("frames", 0)))
        key = f"'{motion.key}'" if motion.key else "0"
        lines = "".join(line + "\\n" for line in motion.lines).replace('"', '\\"')
        word = motion.word or motion.name.replace("_", " ")
        yield (f'    {{"{motion.name}", "{word}", MotionKind::{camel(other[motion.name])}, '
               f'{flag(motion.ball in ("free", "both"))}, '
               f'{flag(motion.ball in ("held", "both"))}, {key},')
        yield f'     {{{wish}}},'
        yield f'     "{lines}"}},'


USES_OF = """// What a special motion is for.
enum class MotionUse : std::uint8_t { rest, kick, block, grab, hold, getUp, show };
constexpr std::array<MotionUse, kMotionKindCount> kMotionUses{
    MotionUse::rest,  // none
"""

FUNCTIONS = """
constexpr MotionUse useOf(MotionKind kind) { return kMotionUses[static_cast<std::size_t>(kind)]; }
constexpr bool isKick(MotionKind kind) { return useOf(kind) == MotionUse::kick; }
constexpr bool isGetUp(MotionKind kind) { return useOf(kind) == MotionUse::getUp; }

}  // namespace kelpie
"""

LIST = """#pragma once

#include "robot/core/Enumerations.h"

namespace kelpie::actuator {

// What `kelpie calibrate motion` wants of a kick: the ball's scatter (cm), the distance that counts
// as 1 (cm), the smallest and the largest direction (deg left), frames of 1/30 s at most. No
// distance: it is learnt as its mirror image.
struct KickWish {
  double scatter, distance, min, max, frames;
};

// A motion as its file lists it.
struct ListedMotion {
  const char* name;
  const char* word;   // for people: "leg left"
  MotionKind mirror;  // with left and right exchanged; itself if it has no side
  bool free;          // a kick of a ball that lies free,
  bool held;          // of one in the hold
  char key;           // of kelpie teleop; 0: none
  KickWish wish;
  const char* lines;  // of its file, which say this
};

constexpr std::array<ListedMotion, kMotionKindCount> kMotionList{{
"""

LIST_END = """}};

constexpr const ListedMotion& listed(MotionKind kind) {
  return kMotionList[static_cast<std::size_t>(kind)];
}

}  // namespace kelpie::actuator
"""


def enumerations_text(found, choices):
    yield HEAD + "#pragma once\n\n#include <array>\n#include <cstddef>\n#include <cstdint>\n"
    yield "namespace kelpie {\n"
    names = ["none", *(motion.name for motion in found)]
    yield from enumeration(
        "MotionKind", "Special motions: key frames that replace the walk while they run. Sides "
        "name where the ball goes or the robot lies.", [camel(name) for name in names])
    for name, values in choices.items():
        yield from enumeration(name, values["about"], [one for one in values if one != "about"])
    yield USES_OF + "\n".join(f"    MotionUse::{camel(motion.use)},  // {motion.name}"
                              for motion in found) + "\n};"
    yield FUNCTIONS


# --- Python --------------------------------------------------------------------------------------

def python(found, choices):
    """The names of the module `kelpie`, and its table of the kicks."""
    names = ["none", *(motion.name for motion in found)]
    yield ", ".join(python_name(name) for name in names) + f" = range({len(names)})"
    for values in choices.values():
        names = [text for name, text in values.items() if name != "about"]
        yield ", ".join(names) + f" = range({len(names)})"
    roles = [name for name in choices["Role"] if name != "about"]
    yield f"ROLE_NAMES = {tuple(roles)!r}"
    yield KICK_CLASS
    other = pairs(found)
    yield "KICKS = {"
    for motion in (one for one in found if one.use == "kick"):
        yield (f"    {python_name(motion.name)}: Kick({motion.name!r}, "
               f"{python_name(other[motion.name])}, {motion.place!r}, {motion.distance!r}, "
               f"{motion.leaf!r}, {motion.hint!r}),")
    yield "}"


KICK_CLASS = '''

class Kick:
    """A kick as its file lists it: `mirror` the motion with sides exchanged, `place` cm ahead and
    to the left where the ball must lie, `distance` cm that it goes, `leaf` of the decision tree, ''
    for one that only follows a grab, `hint` (cm, deg) where to look for the ball then, or None."""
    __slots__ = ('name', 'mirror', 'place', 'distance', 'leaf', 'hint')

    def __init__(self, name, mirror, place, distance, leaf, hint):
        self.name, self.mirror, self.place = name, mirror, place
        self.distance, self.leaf, self.hint = distance, leaf, hint

'''


def wrapped(line):
    """A long line of names over several, as Python takes them."""
    if len(line) <= 100 or " = range" not in line:
        return line
    return " \\\n".join(textwrap.wrap(line, 98, subsequent_indent="    "))


def write(path, text):
    """Only what has changed: whoever includes it is compiled anew."""
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def main(folder, enumerations, out):
    found, choices = motions(folder), read(enumerations)
    write(out / "robot/core/Enumerations.h", "\n".join(enumerations_text(found, choices)))
    write(out / "actuator/MotionList.h", HEAD + LIST + "\n".join(listed(found)) + "\n" + LIST_END)
    text = "\n".join(wrapped(line) for line in python(found, choices))
    write(out / "behaviour/PythonEnumerations.h",
          HEAD + "#pragma once\n\nnamespace kelpie::behaviour {\n\n// Source text of the module "
          "`kelpie`.\nconstexpr const char* kEnumerations = R\"python(" + text +
          "\n)python\";\n\n}  // namespace kelpie::behaviour\n")


if __name__ == "__main__":
    try:
        main(*map(Path, sys.argv[1:4]))
    except Wrong as wrong:
        sys.exit(f"{wrong}")
