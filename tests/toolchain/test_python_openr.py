# SPDX-License-Identifier: Apache-2.0
"""The robot's Python (toolchain/python-openr) in the emulator: it is MIPS II, it starts, its
numbers and its maths are the PC's to the last bit, no file opens, and decide() gives the PC's
Commands, of which another one is noticed. Compiles the interpreter, a minute of CPU time where no
ccache has it. Skipped without the emulator, the cross compiler or the sources
(toolchain/python-openr/fetch)."""

import importlib.machinery
import importlib.util
import math
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "toolchain/python-openr"
FRAMES = 40
# The plain variants of glibc's functions, as on the target (tools/cli/Process.h).
PLAIN_MATHS = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"

pytest.importorskip("unicorn", reason="needs the Debian package python3-unicorn")
if not shutil.which("mipsel-linux-gnu-gcc"):
    pytest.skip("needs the Debian package g++-mipsel-linux-gnu", allow_module_level=True)
fetched = subprocess.run([FOLDER / "fetch"], capture_output=True, text=True)
if fetched.returncode != 0:
    pytest.skip("needs the sources: " + fetched.stderr.strip()[-200:], allow_module_level=True)


def program(name):
    """A script without a suffix, as a module."""
    loader = importlib.machinery.SourceFileLoader("python_openr_" + name, str(FOLDER / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def built():
    done = subprocess.run([FOLDER / "build"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_it_is_mips2(built):
    instructions, functions = map(int, re.findall(r"(\d+) [if]", built))
    assert instructions > 500000 and functions == 0


@pytest.mark.parametrize("body", ["return __builtin_clz(x);",
                                  'asm("cvt.l.d $f0, $f2"); return x;'])
def test_an_instruction_beyond_mips2_is_refused(tmp_path, body):
    source = f"int root(int x) {{ {body} }}\n"
    subprocess.run(["mipsel-linux-gnu-gcc", "-march=mips32r2", "-O2", "-x", "c", "-", "-c", "-o",
                    tmp_path / "own.o"], input=source, text=True, check=True)
    instructions, faults = program("build").beyond_mips2(tmp_path / "own.o")
    assert instructions and faults == ["own.o: root has 1 instructions beyond MIPS II"]


def test_what_is_no_source_of_it_is_refused(tmp_path):
    done = subprocess.run([FOLDER / "build", "--source", tmp_path], capture_output=True, text=True)
    assert done.returncode == 2 and "is not what `fetch` makes" in done.stderr


@pytest.fixture(scope="module")
def image(built, tmp_path_factory):
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


# Each function of maths that behaviours call, at arguments of all sizes that it takes.
MATHS = """
import math
def numbers(least, most, count=240):
    seed, found = 12345, [0.0, -0.0, 0.5, 1.0]
    for _ in range(count):
        seed = (seed * 1103515245 + 12345) % 2 ** 31
        found.append(least + (most - least) * seed / 2 ** 31)
        found.append(found[-1] / 2 ** (seed % 60))
    return [x for x in found if least <= x <= most]
def said():
    wide, angles, ones = numbers(-1e6, 1e6), numbers(-30.0, 30.0), numbers(-1.0, 1.0)
    yield from (f(x) for f in (math.sin, math.cos, math.tan) for x in wide + angles)
    yield from (f(x) for f in (math.asin, math.acos) for x in ones)
    yield from (f(x) for f in (math.exp, math.erf, math.erfc) for x in angles + ones)
    yield from (math.log(abs(x)) for x in wide + ones if x)
    yield from (math.sqrt(abs(x)) for x in wide)
    for x, y in zip(wide, reversed(angles)):
        yield from (math.atan2(x, y), math.atan2(y, x), math.atan(x), math.hypot(x, y))
        yield from ((abs(x) + 0.01) ** y, abs(y) ** 0.5, y ** 2)
        yield from (math.fmod(x, y or 1.0), x % (y or 1.0))
        yield from map(float, (math.floor(x), math.ceil(y), round(y), math.copysign(x, y)))
answer = [x.hex() for x in said()]
"""


def test_its_maths_have_the_pcs_bits(machine):
    pc = subprocess.run(["/usr/bin/python3", "-c", MATHS + "print(answer)"], check=True, text=True,
                        capture_output=True, env={**os.environ, "GLIBC_TUNABLES": PLAIN_MATHS})
    wanted, got = eval(pc.stdout), eval(machine.python(MATHS))
    assert len(set(wanted)) > 10000
    assert got == wanted


def test_maths_that_no_behaviour_calls_raise_an_error(machine):
    said = machine.python("import math\nanswer = math.log10(3.0)\n")
    assert said == "ValueError('math domain error')"


def test_no_file_opens(machine):
    said = machine.python("answer = open('/etc/passwd')\n")
    assert said.startswith("FileNotFoundError"), said


def test_an_error_of_a_script_is_reported_and_the_next_runs(machine):
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
