# SPDX-License-Identifier: Apache-2.0
"""The described vector of the behaviours' constants: what one must say of itself, and that the
behaviours have it as it says."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "behaviour"))
from constants import Wrong, constants  # noqa: E402

SCHEMA = ROOT / "behaviour/constants.toml"
GOOD = '[grab.far]\ndefault = 3.0\nrange = [1.0, 5.0]\nunit = "cm"\nwhat = "how far it is"\n'


def read(tmp_path, text):
    path = tmp_path / "constants.toml"
    path.write_text(text)
    return constants(path)


def test_each_constant_of_the_tree_is_in_its_range_and_described():
    found = constants(SCHEMA)
    assert len(found) > 40
    assert len({one.key for one in found}) == len(found)
    assert all(one.low <= one.default <= one.high for one in found)


def test_each_constant_is_read_by_one_module_of_the_behaviours():
    text = "".join(path.read_text() for path in sorted((ROOT / "pycode").rglob("*.py")))
    for one in constants(SCHEMA):
        name = re.sub("([A-Z])", lambda letter: "_" + letter[1].lower(), one.name)
        assert len(re.findall(rf"^[A-Z_]+ = CONSTANTS\.{name}\b", text, re.M)) >= 1, one.key


def test_a_value_is_written_with_its_unit_and_a_count_without_a_point(tmp_path):
    one, = read(tmp_path, GOOD)
    assert one.key == "behaviour.constants.grab.far"
    assert one.value(2) == '"2.0cm"'
    count, = read(tmp_path, GOOD.replace(".0", "").replace('"cm"', '""'))
    assert count.value(2.4) == "2"


@pytest.mark.parametrize("before, after, said", [
    ("default = 3.0", "default = 7.0", "grab.far.default: is a number of the range"),
    ("default = 3.0", "default = true", "grab.far.default: is a number of the range"),
    ("[1.0, 5.0]", "[1.0]", "grab.far.range: is two numbers, [low, high]"),
    ("default = 3.0", "default = 3", "grab.far.range: of a count, is two counts"),
    ('"cm"', '"inch"', "grab.far.unit: is one of cm, cm/s, s, deg, deg/s, or empty"),
    ('"how far it is"', '""', "grab.far.what: says what the constant does"),
    ('unit = "cm"\n', "", "grab.far: says default, range, unit and what, and nothing else"),
    ("grab.far", "grab.Far", "grab.Far: is no name such as carryTo"),
    ("[grab.far]", "[far]", "far.default: says default, range, unit and what, and nothing else"),
])
def test_one_that_contradicts_itself_is_refused_in_a_line(tmp_path, before, after, said):
    with pytest.raises(Wrong, match=re.escape(said)):
        read(tmp_path, GOOD.replace(before, after))


def test_a_file_that_is_none_is_refused_in_a_line(tmp_path):
    done = subprocess.run(["/usr/bin/python3", ROOT / "behaviour/constants.py",
                           tmp_path / "none.toml", tmp_path / "Constants.h"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "Constants.h").exists()
