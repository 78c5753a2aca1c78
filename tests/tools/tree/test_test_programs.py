# SPDX-License-Identifier: Apache-2.0
"""The C++ tests are in a program: a file that is in none would pass for ever."""

from conftest import BIN, ROOT


def test_every_file_of_tests_is_built_into_a_program():
    rules = (BIN.parent / "build.ninja").read_text()
    files = [path.relative_to(ROOT).as_posix() for path in (ROOT / "tests").rglob("*Test.cpp")]
    assert len(files) > 200
    assert [name for name in files if name not in rules] == []
