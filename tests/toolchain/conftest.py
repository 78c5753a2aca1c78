# SPDX-License-Identifier: Apache-2.0
"""Ten seconds of play, recorded once, as tapes for the object in the emulator."""

import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
# The plain variants of glibc's functions, with which logs are recorded (tools/cli/Process.h).
PLAIN_MATHS = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"


def must(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          timeout=500, env={**os.environ, "GLIBC_TUNABLES": PLAIN_MATHS})
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout.strip()


def tape_writer():
    return Path(os.environ.get("OBJECT_TAPE", ROOT / "build/host/bin/object-tape"))


@pytest.fixture(scope="session")
def log(tmp_path_factory):
    kelpie = os.environ.get("KELPIE", ROOT / "build/host/bin/kelpie")
    return must(ROOT / "toolchain/record", tmp_path_factory.mktemp("log"), kelpie, 10)


@pytest.fixture(scope="session")
def tape(log, tmp_path_factory):
    """With the behaviours, whose Commands are those of the recording."""
    path = tmp_path_factory.mktemp("tape") / "tape"
    said = must(tape_writer(), log, path, 300, ROOT / "pycode")
    assert re.match(r"300 frames, 3\d\d motion steps, 0 differ from the recording", said)
    return path


@pytest.fixture(scope="session")
def simple_tape(log, tmp_path_factory):
    path = tmp_path_factory.mktemp("simple") / "tape"
    writer = tape_writer()
    said = must(writer.with_name(writer.name + "-simple"), log, path, 90)
    assert re.match(r"90 frames, \d+ motion steps, 0 differ from the recording", said)
    return path
