# SPDX-License-Identifier: Apache-2.0
"""Python on the small C library of toolchain/python-openr, in the emulator: it starts, its numbers
are the PC's, no file opens, and decide() gives the PC's Commands, of which another one is noticed.
The interpreter's code is Debian's (MIPS32), so this says nothing of the robot's CPU. Skipped
without the emulator, the cross compiler or the sysroot (toolchain/make-sysroot)."""

import importlib.machinery
import importlib.util
import math
import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "toolchain/python-openr"
SYSROOT = Path(os.environ.get("KELPIE_SYSROOT") or
               Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") /
               "kelpie/sysroot-mipsel")
FRAMES = 40

pytest.importorskip("unicorn", reason="needs the Debian package python3-unicorn")
if not shutil.which("mipsel-linux-gnu-gcc"):
    pytest.skip("needs the Debian package g++-mipsel-linux-gnu", allow_module_level=True)
if not SYSROOT.is_dir():
    pytest.skip("needs the sysroot of toolchain/make-sysroot", allow_module_level=True)


def program(name):
    """A script without a suffix, as a module."""
    loader = importlib.machinery.SourceFileLoader("python_openr_" + name, str(FOLDER / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def image(tmp_path_factory):
    path = tmp_path_factory.mktemp("python") / "image"
    done = subprocess.run([FOLDER / "link", path], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture(scope="module")
def emulate():
    return program("emulate")


@pytest.fixture(scope="module")
def machine(emulate, image):
    started = emulate.PythonMachine(emulate.stages.Elf(image), 0x12345000, counting=False)
    assert started.start() == ""
    return started


@pytest.mark.parametrize("text", [
    "[math.frexp(x) for x in (0.0, -0.0, 1.0, -3.5, 5e-324, 1.7e308, 0.1)]",
    "[math.ldexp(x, n) for x in (1.0, -0.7) for n in (-1074, -1060, -5, 0, 9, 1000)]",
    "[math.modf(x) for x in (0.0, -0.0, 0.25, -7.75, 1e300, -0.1, 4503599627370497.5)]",
    "[math.sin(0.1 * i) for i in range(50)] + [math.atan2(i, 3.0) for i in range(-9, 9)]",
    "['%5d|%-6s|%x|%.3f|%r' % (-42, 'ab', 255, 2.0 / 3.0, 1e-7), str(2 ** 70), hex(-300)]",
    "sorted({'ball': 3, 'goal': 1}.items()), 'Aibo'.lower(), 'a,b'.split(','), '%s' % 1.5",
])
def test_its_python_answers_as_the_pcs(machine, text):
    assert machine.python(f"import math\nanswer = {text}\n") == repr(eval(text, {"math": math}))


def test_no_file_opens(machine):
    said = machine.python("answer = open('/etc/passwd')\n")
    assert said.startswith("FileNotFoundError"), said


def test_an_error_of_a_script_is_told_and_the_next_runs(machine):
    assert machine.python("answer = 1 / 0\n") == "ZeroDivisionError('division by zero')"
    assert machine.python("answer = 7\n") == "7"


@pytest.fixture(scope="module")
def played(emulate, image):
    play = program("play")
    made = play.worlds(FRAMES, 4)
    return play, made, play.started(emulate, image, 0x10000000, False)


def test_decide_gives_the_pcs_commands(played):
    play, made, python = played
    assert len({command for _, command in made}) > FRAMES // 2  # not one Command over and over
    _, first, differing = play.play(python, made)
    assert differing == 0, first


def test_another_command_is_noticed(played):
    play, made, python = played
    world, command = made[-1]
    _, first, differing = play.play(python, [(world, command + " ")])
    assert differing == 1 and first.startswith("frame 0: ")
