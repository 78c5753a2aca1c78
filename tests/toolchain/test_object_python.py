# SPDX-License-Identifier: Apache-2.0
"""Python in the robot's object: other behaviours than recorded are noticed; a script that does not
end, goes too deep or eats memory costs its frame and no more; the stack that the gates count on is
what the dearest calls take; and the gates look into the interpreter. Run by ctest, which builds the
object and names the PC's programs."""

import importlib.machinery
import importlib.util
import marshal
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import PLAIN_MATHS, tape_writer
from test_object import FLAGS, must, refusal, run

ROOT = Path(__file__).resolve().parents[2]
TOOLCHAIN = ROOT / "toolchain"
sys.path.insert(0, str(TOOLCHAIN))
pytest.importorskip("unicorn", reason="needs the Debian package python3-unicorn")
# Of the list of robot/core/types/Command.h.
NOT_LOADED, SCRIPT_ERROR, TIME_LIMIT = 1, 2, 4


def emulator():
    loader = importlib.machinery.SourceFileLoader("emulate", str(TOOLCHAIN / "emulate"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("emulate", loader))
    loader.exec_module(module)
    return module


emulate = emulator()


class Player:
    """The image with Python, configured, with frames of the tape to play: by the behaviours of a
    zip, or by those inside."""

    def __init__(self, tape, scripts=None):
        self.machine = emulate.Machine(emulate.Elf(ROOT / "build/openr/emulated"), 0x12345000)
        if scripts is not None:
            self.machine.put_file(scripts)
        records = emulate.records_of(tape)
        kind, config, _ = next(records)
        assert kind == b"c" and self.machine.give("kelpieConfigure", config)
        self.frames = ((data, made) for kind, data, made in records if kind == b"f")

    def frame(self):
        """(what the PC made of the next frame, what the image makes of it)"""
        data, made = next(self.frames)
        return made, self.machine.give("kelpieFrame", data)

    def fallback(self):
        """Of the next Command; a fallback's has no trace, whose length ends the output."""
        _, got = self.frame()
        assert got[-4:] == bytes(4)
        return got[-5]

    def console(self):
        size = self.machine.call("kelpieConsoleSize")
        return bytes(self.machine.cpu.mem_read(self.machine.call("kelpieConsole"), size)).decode()

    def run(self, text):
        code = marshal.dumps(compile(text, "test", "exec"))
        return self.machine.give("kelpieRun", code).decode()

    def decide(self, body):
        """Puts another text into the function that the host calls."""
        return self.run(f"""
import gc
main = [it for it in gc.get_objects() if type(it).__name__ == 'Version'][0].modules['main']
def decide(world):
    {body}
kept = main.__dict__.setdefault('kept', main.decide.__code__)
main.decide.__code__ = kept if {body!r} == 'kept' else decide.__code__
answer = 'put'
""")


@pytest.fixture(scope="module")
def started(tape):
    return Player(tape)


@pytest.fixture
def player(started):
    """The same for all, since a start takes 112 million instructions, with its own decide()."""
    started.machine.forget_stack()
    yield started
    started.decide("kept")
    started.frame()  # or too many of them hit the time limit in a row


def test_another_version_of_the_behaviours_than_recorded_is_noticed(log, tmp_path):
    shutil.copytree(ROOT / "pycode", tmp_path / "pycode")
    main = tmp_path / "pycode/main.py"
    main.write_text(main.read_text() + "\n\ndef decide(world):\n    return kelpie.Command()\n")
    done = subprocess.run([tape_writer(), log, tmp_path / "tape", "30", tmp_path / "pycode"],
                          capture_output=True, text=True,
                          env={**os.environ, "GLIBC_TUNABLES": PLAIN_MATHS})
    assert done.returncode == 1
    assert re.search(r"frame 0: command\.", done.stderr)


def zip_of(folder, **texts):
    """A stick's PYCODE.ZIP of modules with these texts."""
    for name, text in texts.items():
        path = folder / "scripts" / (name.replace("__", "/") + ".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    must(TOOLCHAIN / "make-pyzip", folder / "PYCODE.ZIP", "--pycode", folder / "scripts")
    return (folder / "PYCODE.ZIP").read_bytes()


MAIN = """import kelpie
from lib import words


def decide(world):
    raise ValueError(words.SAID)
"""


def test_behaviours_of_the_stick_play_with_their_folders(tape, tmp_path):
    player = Player(tape, zip_of(tmp_path, main=MAIN, lib__words="SAID = 'from the stick'\n"))
    assert player.fallback() == SCRIPT_ERROR
    assert player.console() == "behaviour: main.py:6: ValueError: from the stick\n"


def packed(data):
    at = data.index(b"PK\1\2") + 10
    return data[:at] + b"\x08" + data[at + 1:]


@pytest.mark.parametrize("damage, said", [
    (lambda data: data[:-30], "this is no zip, or is cut off"),
    (lambda data: b"", "this is no zip, or is cut off"),
    (packed, "what the zip holds is packed"),
    (lambda data: data.replace(importlib.util.MAGIC_NUMBER, b"\x00\x00\r\n"),
     "main.pyc is of another Python")])
def test_zip_that_cannot_be_played_is_reported_and_plays_nothing(tape, tmp_path, damage, said):
    data = damage(zip_of(tmp_path, main="def decide(world): pass\n"))
    player = Player(tape, data)
    assert player.fallback() == NOT_LOADED
    assert player.console() == f"behaviour: ImportError: {said}\n"


def test_script_that_does_not_end_costs_its_frame_at_the_same_step_in_every_run(tape):
    steps = []
    for _ in range(2):
        player = Player(tape)
        assert player.decide("while True: pass") == "'put'"
        before = player.machine.call("kelpieSteps")
        assert player.fallback() == TIME_LIMIT
        steps.append(player.machine.call("kelpieSteps") - before)
    assert steps[0] == steps[1] > 70000


@pytest.mark.parametrize("body", [
    "while True:\n        try:\n            while True: pass\n        except: pass",
    "f = lambda n: 0 if n == 0 else f(n - 1) + f(n - 1)\n    return f(40)",
    "return sum(1 for i in range(10 ** 9))",
    "return 7 ** 10 ** 7"])
def test_script_that_catches_or_hides_its_loop_ends_too(player, body):
    player.decide(body)
    assert player.fallback() == TIME_LIMIT


def test_script_plays_on_after_one_that_did_not_end(player):
    player.decide("while True: pass")
    assert player.fallback() == TIME_LIMIT
    player.decide("kept")
    made, got = player.frame()
    assert len(got) == len(made) and got[-4:] != bytes(4)  # a trace, so a Command of the behaviours


@pytest.mark.parametrize("body, reason", [("f = lambda: f()\n    f()", SCRIPT_ERROR),
                                          ("return 1 / 0", SCRIPT_ERROR), ("return 7", 3)])
def test_error_of_a_script_is_a_fallback_as_on_the_pc(player, body, reason):
    player.decide(body)
    assert player.fallback() == reason


@pytest.mark.parametrize("body", [
    "return [0] * 3500000", "return len('a' * 10 ** 8)", "x = []\n    while True: x = [x] * 100",
    "x = []\n    for i in range(10 ** 9): x.append('word' * 10000)"])
def test_script_that_eats_memory_is_refused_it_and_the_next_one_plays(player, body):
    player.decide(body)
    assert player.fallback() == SCRIPT_ERROR
    assert "MemoryError: it takes more memory than it is given" in player.console()
    player.decide("return [0] * 100000")
    assert player.fallback() == 3  # a list is no Command


def test_script_prints_to_where_errors_are_reported(tape, tmp_path):
    player = Player(tape, zip_of(tmp_path, main=MAIN.replace("raise ValueError", "print"),
                                 lib__words="SAID = 'from the stick'\n"))
    player.fallback()
    assert player.console().startswith("behaviour: from the stick\n")


# Each calls itself by another way through the interpreter, as deep as the host allows.
DEEP = {
    "sorting": "def f(x=0): sorted([1, 2], key=f)",
    "comparing": "class A:\n    def __lt__(self, o): return sorted([self, o])\n"
                 "def f(): sorted([A(), A()])",
    "mapping": "def f(x=0): list(map(f, [1]))",
    "attribute": "class A:\n    def __getattr__(self, n): return getattr(self, n + 'x')\n"
                 "def f(): A().p",
    "iterating": "class A:\n    def __iter__(self): return iter(list(self))\ndef f(): list(A())",
    "adding": "class A:\n    def __add__(self, o): return self + o\n    __radd__ = __add__\n"
              "def f(): A() + 1",
    "keywords": "def h(*a, **k): return h(*a, **k)\ndef f(): h(1, x=2)",
    "generators": "def g():\n    yield from g()\ndef f(): list(g())",
    "nested lists": "def f():\n    x = []\n    for i in range(5000): x = [x]\n    repr(x)",
    "an error in an error": "class E(Exception):\n    def __str__(self): return str(E(self))\n"
                            "def f(): str(E())",
}


def interpreters_stack():
    line = next(line for line in (TOOLCHAIN / "openr/calls.txt").read_text().splitlines()
                if line.startswith("interpreter "))
    return int(line.split()[1])


@pytest.mark.parametrize("way", DEEP)
def test_deepest_calls_stay_within_the_stack_that_the_gates_count_on(player, way):
    said = player.run(DEEP[way] + "\ntry:\n    f()\nexcept RecursionError:\n    answer = 'deep'\n")
    assert said == "'deep'"
    assert 2000 < player.machine.stack_used() < interpreters_stack()


def test_dearest_calls_take_most_of_the_stack_that_the_gates_count_on(player):
    player.run(DEEP["sorting"] + "\ntry:\n    f()\nexcept RecursionError: pass\n")
    assert player.machine.stack_used() > 0.8 * interpreters_stack()


INTERPRETER = """
extern "C" void* memset(void*, int, unsigned);
extern "C" int inside(int (*f)(int), int x) { BODY }
"""
OUTSIDE = """
extern "C" void* memset(void*, int, unsigned);
extern "C" int inside(int (*f)(int), int x);
extern "C" int root(int x) { char room[SIZE]; memset(room, x, sizeof room);
  return inside(nullptr, room[3]) + room[5]; }
"""


def with_interpreter(folder, body, size=100, *flags):
    """A partial link of a function that stands for the interpreter, and one that calls it."""
    (folder / "robot").mkdir()
    for name, text in (("inside", INTERPRETER.replace("BODY", body)),
                       ("outside", OUTSIDE.replace("SIZE", str(size)))):
        (folder / f"{name}.cpp").write_text(text)
        more = flags if name == "inside" else ()
        must("mipsel-linux-gnu-g++", *FLAGS, *more, "-c", "-o", folder / f"{name}.o",
             folder / f"{name}.cpp")
    must("mipsel-linux-gnu-ar", "rcs", folder / "robot/libpython.a", folder / "inside.o")
    must("mipsel-linux-gnu-ld", "-EL", "-m", "elf32ltsmip", "-r", "--gc-sections",
         "--undefined=root", "-T", TOOLCHAIN / "openr/object.ld", "-o", folder / "tiny.o",
         folder / "outside.o", folder / "robot/libpython.a")
    return folder / "tiny.o"


POINTER = "return f(x) + 1 + inside(f, x - 1);"


def test_interpreter_may_call_by_pointers_and_itself(tmp_path):
    done = run(TOOLCHAIN / "check-object", with_interpreter(tmp_path, POINTER))
    assert done.returncode == 0, done.stderr


def test_stack_of_the_interpreter_is_counted_for_who_calls_it(tmp_path):
    done = run(TOOLCHAIN / "check-object", with_interpreter(tmp_path, POINTER))
    depth = int(re.search(r"deepest path (\d+) bytes", done.stdout)[1])
    assert interpreters_stack() < depth < interpreters_stack() + 1024


def test_deep_path_before_the_interpreter_is_refused(tmp_path):
    found = refusal(with_interpreter(tmp_path, POINTER, 62 * 1024))
    assert "root -> Python's interpreter" in found["deepest_path"][0]


def test_large_frame_in_the_interpreter_is_refused(tmp_path):
    found = refusal(with_interpreter(
        tmp_path, "char room[21 * 1024]; memset(room, x, sizeof room); return f(room[7]);"))
    assert re.match(r"inside takes 21\d+ bytes of stack, at most 20480", found["stack_frames"][0])


def test_instruction_beyond_mips_ii_in_the_interpreter_is_refused(tmp_path):
    found = refusal(with_interpreter(
        tmp_path, 'asm(".set mips32r2\\nclz %0, %0" : "+r"(x)); return f(x);'))
    assert found == {
        "instruction_set": ["inside has 1 instructions beyond MIPS II: SPECIAL2 of MIPS32"]}


def test_name_that_the_interpreter_wants_of_nobody_is_refused(tmp_path):
    found = refusal(with_interpreter(
        tmp_path, 'extern int printf(const char*, ...) __asm__("printf"); return printf("x") + x;'))
    assert found == {"undefined_names": ["wants printf, which is not in openr/undefined.txt"]}
