# SPDX-License-Identifier: Apache-2.0
"""What tools/build-cost writes down of each compilation."""

import subprocess

from conftest import ROOT


def compile_by(log, script):
    command = [ROOT / "tools/build-cost", "--compile", log, "sh", "-c", script, "sh", "-c", "a.cpp"]
    return subprocess.run(command, timeout=60, check=False).returncode


def test_a_compilation_is_one_line_of_seconds_kilobytes_and_source(tmp_path):
    log = tmp_path / "costs"
    for _ in range(2):
        assert compile_by(log, "head -c 20000000 /dev/zero | od > /dev/null") == 0
    rows = [line.split("\t") for line in log.read_text().splitlines()]
    assert [row[2] for row in rows] == ["a.cpp", "a.cpp"]
    assert all(float(row[0]) > 0.0 and int(row[1]) > 500 for row in rows)


def test_a_compiler_that_fails_fails_the_build(tmp_path):
    assert compile_by(tmp_path / "costs", "exit 3") == 3


def test_an_unknown_commit_is_refused():
    done = subprocess.run([ROOT / "tools/build-cost", "nonsense"], timeout=60, check=False,
                          capture_output=True, text=True)
    assert done.returncode == 2 and "nonsense" in done.stderr
