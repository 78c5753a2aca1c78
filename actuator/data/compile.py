#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the standard walks and motions as C++: compile.py WALKS MOTIONS OUT.cpp

A walk's keys are those of WalkSet's fields, in the syntax of parameter files; a motion's are
given in actuator/README.md. What is wrong in a file ends the build with `file: what`."""

import re
import sys
import tomllib
from pathlib import Path

import registry

MOUTH_SHUT = -3
LEGS = ["left_front", "left_hind", "right_front", "right_hind"]
MOTION_KEYS = {"about", "motion", "learn", "slew", "at_once", "return_ticks", "hurried_by", "way",
               "kick", "frame"}
FRAME_KEYS = {"ticks", "interpolate", "gain", "head", "asks_pan", "mouth", "legs", "walk",
              "forward", "left", "turn", "front", "hind", *LEGS}


class Wrong(Exception):
    pass


def degrees(value):
    return f"Angle::deg({float(value)})"


def text_value(text):
    """A number with its unit as parameter files write it: an angle, or a bare number."""
    number, unit = re.fullmatch(r"(-?[0-9.e-]*[0-9.])\s*(\S*)", text).groups()
    return degrees(number) if unit == "deg" else str(float(number))


def assignments(path, table):
    for key, value in table.items():
        where = f"{path}.{key}"
        if isinstance(value, dict):
            yield from assignments(where, value)
        elif key == "locus":
            yield f"{where} = static_cast<LocusShape>({int(value)});"
        else:
            yield f"{where} = {text_value(value) if isinstance(value, str) else float(value)};"


def check_keys(table, known):
    for key in table:
        if key not in known:
            raise Wrong(f"{key}: there is no such key")


def array_of(values, count, what):
    if not isinstance(values, list) or len(values) != count:
        raise Wrong(f"{what}: wants {count} angles in degrees")
    return "{" + ", ".join(degrees(v) for v in values) + "}"


def gain(value):
    """A share of the standard gain of the legs."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Wrong("gain: is a number")
    if not 0.2 <= value <= 1:
        raise Wrong(f"gain: {value} is outside 0.2..1")
    return float(value)


def leg_angles(frame):
    angles = []
    for leg in LEGS:
        values = frame.get(leg, frame.get(leg.split("_")[1]))
        if values is None:
            raise Wrong(f"{leg}: has no angles")
        array_of(values, 3, leg)
        angles += values
    return angles


def legs(frame):
    if any(key in frame for key in ("front", "hind", *LEGS)):
        yield "key.legs = KeyLegs::angles;"
        yield f"key.angles = {{{array_of(leg_angles(frame), 12, 'legs')}}};"
        return
    yield f"key.legs = KeyLegs::{frame.get('legs', 'stay')};"
    yield f"key.walk.kind = WalkKind::{frame.get('walk', 'normal')};"
    for speed in ("forward", "left"):
        yield f"key.walk.{speed} = {float(frame.get(speed, 0))};"
    yield f"key.walk.turn = Angle::deg({float(frame.get('turn', 0))}).rad();"


def key_frame(frame):
    check_keys(frame, FRAME_KEYS)
    yield "{ KeyFrame key;"
    yield f"key.ticks = {int(frame['ticks'])};"
    yield f"key.interpolate = {str(frame.get('interpolate', False)).lower()};"
    yield f"key.gain = {gain(frame.get('gain', 1))};"
    if "head" in frame:
        yield f"key.movesHead = true; key.head = {{{array_of(frame['head'], 3, 'head')}}};"
    yield f"key.asksPan = {str(frame.get('asks_pan', False)).lower()};"
    yield f"key.mouth = {degrees(frame.get('mouth', MOUTH_SHUT))};"
    if "mouth" in frame:
        yield "key.movesMouth = true;"
    yield from legs(frame)
    yield "motion.frames.push_back(key); }"


def hurrying(table, names):
    """The motion that, asked for, makes this one go twice as fast."""
    name = table.get("hurried_by", "none")
    if name not in names:
        raise Wrong(f"hurried_by: there is no motion {name}")
    return f"motion.hurriedBy = MotionKind::{registry.camel(name)};"


def motion(name, table, names):
    check_keys(table, MOTION_KEYS)
    yield f"void {name}(MotionData& motion) {{"
    yield f"motion.slew = {degrees(table.get('slew', 20))};"
    yield f"motion.atOnce = {str(table.get('at_once', False)).lower()};"
    yield f"motion.returnTicks = {int(table.get('return_ticks', 30))};"
    yield hurrying(table, names)
    way = table.get("way", {})
    check_keys(way, {"forward", "left", "turn", "forward_sd", "left_sd", "turn_sd"})
    for axis in ("forward", "left"):
        yield f"motion.way.{axis} = {float(way.get(axis, 0))};"
        yield f"motion.way.{axis}Sd = {float(way.get(axis + '_sd', 0))};"
    yield f"motion.way.turn = {degrees(way.get('turn', 0))};"
    yield f"motion.way.turnSd = {degrees(way.get('turn_sd', 0))};"
    kick = table.get("kick", {})
    check_keys(kick, {"ahead", "left", "distance", "distance_sd", "direction", "direction_sd"})
    for key in ("ahead", "left", "distance"):
        yield f"motion.kick.{key} = {float(kick.get(key, 0))};"
    yield f"motion.kick.distanceSd = {float(kick.get('distance_sd', 0))};"
    yield f"motion.kick.direction = {degrees(kick.get('direction', 0))};"
    yield f"motion.kick.directionSd = {degrees(kick.get('direction_sd', 0))};"
    for frame in table["frame"]:
        yield from key_frame(frame)
    yield "}"


def read(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


def other_side(frame):
    """A key frame with left and right exchanged, the head turned to the other side."""
    swapped = {key: value for key, value in frame.items() if key not in LEGS}
    for key in set(LEGS) & set(frame):
        side, leg = key.split("_")
        swapped[{"left": "right", "right": "left"}[side] + "_" + leg] = frame[key]
    if "head" in frame:
        neck, pan, nod = frame["head"]
        swapped["head"] = [neck, 0 - pan, nod]
    for key in set(frame) & {"left", "turn"}:
        swapped[key] = 0 - frame[key]
    return swapped


def read_motion(path):
    table = read(path)
    if "mirror" not in table:
        return table
    check_keys(table, {"mirror", "about", "motion"})
    table = read(path.with_name(table["mirror"] + ".toml"))
    for part in ("way", "kick"):
        for key in set(table.get(part, {})) & {"left", "turn", "direction"}:
            table[part][key] = 0 - table[part][key]
    return {**table, "frame": [other_side(frame) for frame in table["frame"]]}


def program(walks, folder):
    yield "// Written by actuator/data/compile.py from actuator/data."
    yield '#include "actuator/motion/MotionData.h"'
    yield '#include "actuator/walk/WalkSet.h"'
    yield "namespace kelpie::actuator {"
    listed = ["none", *(one.name for one in registry.motions(folder))]
    names = ", ".join(f'"{name}"' for name in listed)
    yield f"const std::array<const char*, kMotionKindCount> kMotionNames{{{names}}};"
    yield "namespace {"
    yield "WalkSets walks() { WalkSets sets;"
    for path in sorted(walks.glob("*.toml")):
        yield from assignments("sets", read(path)["actuator"]["walks"])
    yield "return sets; }"
    found = listed[1:]
    for name in found:
        try:
            yield from motion(name, read_motion(folder / f"{name}.toml"), listed)
        except (Wrong, KeyError) as wrong:
            raise SystemExit(f"{folder / name}.toml: {wrong}")
    yield "Motions motions() { Motions all;"
    yield from (f"{name}(all.of[{listed.index(name)}]);" for name in found)
    yield "return all; }"
    yield "}  // namespace"
    yield "const WalkSets& standardWalks() { static const WalkSets sets = walks(); return sets; }"
    yield "const Motions& standardMotions() { static const Motions all = motions(); return all; }"
    yield "}  // namespace kelpie::actuator"


if __name__ == "__main__":
    try:
        text = "\n".join(program(Path(sys.argv[1]), Path(sys.argv[2]))) + "\n"
    except registry.Wrong as wrong:
        sys.exit(f"{wrong}")
    Path(sys.argv[3]).write_text(text)
