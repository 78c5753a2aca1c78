# SPDX-License-Identifier: Apache-2.0
"""The robot's object: each gate of check-object refuses the fault that it is for, planted in a tiny
object; the emulated image gives the PC's bits, and other ones are noticed; our own parts of the C
library do as the PC's. Run by ctest, which builds the object and names the PC's programs."""

import math
import os
import random
import re
import struct
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOLCHAIN = ROOT / "toolchain"
OBJECT = ROOT / "build/openr/agent.o"
SIMPLE = ROOT / "build/openr/simple.o"
IMAGE = ROOT / "build/openr/emulated"
sys.path.insert(0, str(TOOLCHAIN))
from openr.calls import Calls  # noqa: E402
from openr.elf import Elf  # noqa: E402

FLAGS = ("-O2 -EL -march=mips2 -mabi=32 -mfp32 -mabicalls -mshared -fPIC -G0 -mno-plt "
         "-mno-relax-pic-calls -fno-jump-tables -fno-exceptions -fno-rtti "
         "-fno-asynchronous-unwind-tables -fno-use-cxa-atexit -fno-stack-protector "
         "-ffunction-sections -fno-builtin").split()


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          timeout=500, **options)


def must(*command):
    done = run(*command)
    assert done.returncode == 0, done.stderr
    return done.stdout


def compiled(folder, source, *flags, suffix="cpp"):
    """A partial link of one source as the preset makes it."""
    (folder / f"own.{suffix}").write_text(source)
    must("mipsel-linux-gnu-g++", *FLAGS, *flags, "-c", "-o", folder / "own.o",
         folder / f"own.{suffix}")
    must(TOOLCHAIN / "openr/partial-link", folder / "tiny.o", "--require-defined=root",
         folder / "own.o")
    return folder / "tiny.o"


def linked(folder, script):
    must("mipsel-linux-gnu-ld", "-EL", "-m", "elf32ltsmip", "-r", "--gc-sections",
         "--undefined=root", "-T", script, "-o", folder / "tiny.o", folder / "own.o")
    return folder / "tiny.o"


def refusal(path):
    """{gate: its lines}; the object must be refused."""
    done = run(TOOLCHAIN / "check-object", path)
    assert done.returncode == 1, done.stdout + done.stderr
    faults = re.findall(r"^check-object: (\w+): (.*)$", done.stderr, re.M)
    return {gate: [line for other, line in faults if other == gate] for gate, _ in faults}


@pytest.mark.parametrize("player", [OBJECT, SIMPLE])
def test_robots_object_passes_every_gate(player):
    done = run(TOOLCHAIN / "check-object", player)
    assert done.returncode == 0, done.stderr
    assert "13 gates, no fault" in done.stdout


@pytest.mark.parametrize("player", [OBJECT, SIMPLE])
def test_robots_object_tells_neither_when_nor_where_it_was_built(player):
    """So that two builds are equal: CPython's own says date and time, compilers name folders."""
    content = player.read_bytes()
    assert str(ROOT).encode() not in content
    assert not re.search(rb"\b[A-Z][a-z]{2} [ \d]\d 20\d\d\b|\d\d:\d\d:\d\d\0", content)


@pytest.mark.parametrize("player, has, has_not", [
    (OBJECT, ["_PyEval_EvalFrameDefault", "kelpie::behaviour::PythonHost::decide"],
     ["kelpie::object::SimpleState"]),
    (SIMPLE, ["kelpie::object::SimpleState"], ["PyObject_Call", "kelpie::behaviour::PythonHost"])])
def test_object_has_its_own_player_and_no_other(player, has, has_not):
    defined = must("mipsel-linux-gnu-nm", "-C", "--defined-only", player)
    assert [name for name in has if name not in defined] == []
    assert [name for name in has_not if name in defined] == []


@pytest.mark.parametrize("name", [
    " Self", "kelpie::object::RobotAgent::beforeMotion", "kelpie::agent::Agent::NotifyImage",
    "kelpie::agent::AntEndpoint::tick", "kelpie::stick::StickReader::load",
    "kelpie::agent::AgentLoops::camera", "kelpie::agent::FaultLoops::motion"])
def test_robots_object_has_what_it_starts_and_plays_with(name):
    defined = must("mipsel-linux-gnu-nm", "-C", "--defined-only", OBJECT)
    assert name in defined


def test_object_without_a_fault_passes(tmp_path):
    path = compiled(tmp_path, 'extern "C" void* memset(void*, int, unsigned); extern "C" int root('
                    'int* p) { memset(p, 1, 9); return *p; }')
    done = run(TOOLCHAIN / "check-object", path)
    assert done.returncode == 0, done.stderr


def test_object_marked_as_of_a_later_instruction_set_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'extern "C" int root(int x) { return x; }', "-march=mips4"))
    assert "is marked as of a later instruction set" in found["instruction_set"][0]


def test_relocation_that_gensnap_does_not_know_is_refused(tmp_path):
    source = '.text\n.globl root\n.ent root\nroot: jal root\nnop\n.end root\n'
    found = refusal(compiled(tmp_path, source, "-mno-abicalls", "-fno-pic", "-mno-shared",
                             suffix="s"))
    assert "R_MIPS_26" in found["relocation_types"][0]


def test_jump_table_without_reginfo_is_refused(tmp_path):
    table = "".join(f"case {i}: return {i * i * 7 % 11}({i});" for i in range(12))
    table = re.sub(r"(\d+)\((\d+)\)", r"x * \1 + root(\2)", table)
    path = compiled(tmp_path, 'extern "C" int root(int x) { switch (x) {' + table +
                    '} return 0; }', "-fjump-tables")
    assert "relocation_types" not in refusal(path)
    script = tmp_path / "lost.ld"
    text = (TOOLCHAIN / "openr/object.ld").read_text()
    script.write_text(text.replace(".reginfo 0 : { KEEP(*(.reginfo)) }", "")
                      .replace("*(.MIPS.abiflags", "*(.reginfo .MIPS.abiflags"))
    found = refusal(linked(tmp_path, script))
    assert "R_MIPS_GPREL32 and no .reginfo" in found["relocation_types"][0]


def test_absolute_address_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'int there = 3; extern "C" int root() { return there; }',
                             "-mno-abicalls", "-fno-pic", "-mno-shared"))
    assert "of there, which no loader corrects" in found["absolute_addresses"][0]


def test_name_that_nobody_has_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'extern "C" void printf(const char*); extern "C" void '
                             'root() { printf("x"); }'))
    assert found == {"undefined_names": ["wants printf, which is not in openr/undefined.txt"]}


@pytest.mark.parametrize("player", [OBJECT, SIMPLE])
def test_only_the_start_of_the_object_waits_for_the_network(player):
    """What the system calls while the joints move reaches no call that waits."""
    calls = Calls(Elf(player))
    entries = {found[1]: name for name in calls.callees if (found := re.match(
        r"_ZN6kelpie5agent5Agent\d+((Do|Notify|Ready)[A-Z][a-z]+)E", name))}
    assert {"NotifySensor", "NotifyImage", "NotifyControl", "NotifyTeam"} <= set(entries)
    assert [entry for entry, name in entries.items()
            if "_ZN9antEnvMsg4CallE11antStackRefi" in calls.reached_from(name)] == ["DoStart"]


@pytest.mark.parametrize("name", ["lround", "floor", "sin"])
def test_maths_function_that_was_not_compared_is_refused(tmp_path, name):
    found = refusal(compiled(tmp_path, f'extern "C" double {name}(double); extern "C" double '
                             f'root(double x) {{ return {name}(x) + 1.0; }}'))
    assert found["maths_functions"] == [
        f"wants {name} of the C library, which nobody has compared on the robot"]


def test_call_by_a_pointer_that_no_list_names_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'extern "C" int root(int (*f)(int)) { return f(3) + 1; }'))
    assert found == {"indirect_calls": [
        "root calls by a pointer and is not in openr/calls.txt"]}


def test_call_in_place_of_a_return_by_a_pointer_is_seen_too(tmp_path):
    found = refusal(compiled(tmp_path, 'extern "C" int root(int (*f)(int)) { return f(3); }'))
    assert "indirect_calls" in found


def test_pointer_that_is_only_sometimes_a_known_function_is_seen(tmp_path):
    found = refusal(compiled(tmp_path, """
__attribute__((noinline)) static int known(int x) { return x * 3; }
extern "C" int root(int (**f)(int), int x) { return (x > 3 ? known : f[x])(x) + known(x); }"""))
    assert "root calls by a pointer" in found["indirect_calls"][0]


TAKES = 'extern "C" void* memset(void*, int, unsigned);\n'


@pytest.mark.parametrize("size", [21 * 1024, 70 * 1024])
def test_large_frame_is_refused(tmp_path, size):
    found = refusal(compiled(tmp_path, TAKES + f'extern "C" int root() {{ char x[{size}]; '
                             'memset(x, 1, sizeof x); return x[7]; }'))
    taken = re.match(r"root takes (\d+) bytes of stack, at most 20480", found["stack_frames"][0])
    assert size <= int(taken[1]) < size + 64


def test_frame_of_unknown_size_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, TAKES + 'extern "C" int root(int n) { char x[n]; '
                             'memset(x, 1, n); return x[7]; }'))
    assert "root takes a stack of a size that is not known" in found["stack_frames"]


def test_deep_path_of_small_frames_is_refused(tmp_path):
    steps = "".join(
        f'__attribute__((noinline)) static int f{i}(char* c) {{ char x[19000]; memset(x, *c, '
        f'sizeof x); return x[3] + f{i - 1}(x); }}\n' if i else
        '__attribute__((noinline)) static int f0(char* c) { return c[5] * 3; }\n' for i in range(5))
    found = refusal(compiled(tmp_path, TAKES + steps + 'extern "C" int root() { char c = 3; '
                             'return f4(&c) + 1; }'))
    assert list(found) == ["deepest_path"]
    assert re.match(r"a path takes 7\d{4} bytes of stack, at most 61440: root -> ",
                    found["deepest_path"][0])


def test_function_that_calls_itself_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'extern "C" int root(int x) { return x < 2 ? x : '
                             'root(x - 1) * root(x / 2); }'))
    assert found == {"deepest_path": ["root calls itself and is not in openr/calls.txt"]}


def test_functions_that_call_each_other_without_end_are_refused(tmp_path):
    found = refusal(compiled(tmp_path, """
extern "C" int root(int x);
__attribute__((noinline)) int other(int x) { return root(x - 1) * 3; }
extern "C" int root(int x) { return x < 2 ? x : other(x) + 1; }"""))
    assert found["deepest_path"][0].startswith("functions call each other without end: ")


def test_got_that_is_too_large_is_refused(tmp_path):
    loads = "".join(f"lw $2, %got(g{i})($28)\n" for i in range(15400))
    data = "".join(f".globl g{i}\ng{i}: .word {i}\n" for i in range(15400))
    found = refusal(compiled(tmp_path, f".text\n.globl root\n.ent root\nroot: .set noreorder\n"
                             f"{loads} jr $31\nnop\n.end root\n.data\n{data}", suffix="s"))
    assert re.match(r"wants 154\d\d words of the GOT, at most 15360", found["got_size"][0])


def test_static_constructor_that_allocates_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, """
extern "C" void* malloc(unsigned);
struct Holder { void* memory; Holder() : memory(malloc(3)) {} };
Holder holder;
extern "C" void* root() { return holder.memory; }"""))
    assert list(found) == ["constructors"]
    assert "allocates (malloc)" in found["constructors"][0]


def test_file_that_is_no_object_ends_with_2_and_a_line(tmp_path):
    (tmp_path / "text").write_text("no object")
    done = run(TOOLCHAIN / "check-object", tmp_path / "text")
    assert done.returncode == 2 and "no 32-bit little-endian MIPS ELF file" in done.stderr
    whole = OBJECT.read_bytes()
    (tmp_path / "cut").write_bytes(whole[:len(whole) // 2])
    done = run(TOOLCHAIN / "check-object", tmp_path / "cut")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    (tmp_path / "start.c").write_text("void __start(void) {}")
    must("mipsel-linux-gnu-gcc", "-nostdlib", "-static", "-o", tmp_path / "linked",
         tmp_path / "start.c")
    done = run(TOOLCHAIN / "check-object", tmp_path / "linked")
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "is linked" in done.stderr


def test_struct_of_another_size_does_not_compile_for_the_robot(tmp_path):
    """What robot/openr's headers assert is compiled for 32 bits (robot/object/OpenrLayout.cpp)."""
    include = tmp_path / "include"
    (include / "OPENR").mkdir(parents=True)
    for header in (ROOT / "robot/openr/include").rglob("*.h"):
        text = header.read_text()
        if header.name == "ODataFormats.h":
            text = re.sub(r"(struct OSensorValue \{)", r"\1 int planted;", text)
        (include / header.relative_to(ROOT / "robot/openr/include")).write_text(text)
    command = ["mipsel-linux-gnu-g++", *FLAGS, "-std=c++17", "-fsyntax-only", "-I", ROOT,
               ROOT / "robot/object/OpenrLayout.cpp", "-I"]
    assert run(*command, ROOT / "robot/openr/include").returncode == 0
    planted = run(*command, include)
    assert planted.returncode != 0 and "static assertion failed" in planted.stderr


def short(tape, to, records, change=None):
    """The first records of a tape; `change` may alter (index, kind, input, output)."""
    data, at, out = tape.read_bytes(), 0, bytearray()
    for index in range(records):
        kind, size, made = struct.unpack_from("<cII", data, at)
        fed, answer = data[at + 9:at + 9 + size], data[at + 9 + size:at + 9 + size + made]
        at += 9 + size + made
        if change:
            fed, answer = change(index, kind, fed, answer)
        out += struct.pack("<cII", kind, len(fed), len(answer)) + fed + answer
    to.write_bytes(out)
    return to


def test_object_gives_the_bits_of_the_pc_at_two_addresses(tape):
    """Those of the Commands of the behaviours too, which the PC made when the log was recorded."""
    done = run(TOOLCHAIN / "emulate", "--tape", tape)
    assert done.returncode == 0, done.stderr
    assert re.findall(r"^(0x\w+): 0 of 300 frames differ, 0 of 3\d\d motion steps", done.stdout,
                      re.M) == ["0x10000000", "0x12345000"]
    for stack in re.findall(r"stack (\d+) bytes", done.stdout):
        assert 20000 < int(stack) < 60 * 1024


def test_object_with_the_simple_player_gives_the_bits_of_the_pc(simple_tape):
    done = run(TOOLCHAIN / "emulate", "--simple", "--at", "0x12345000", "--tape", simple_tape)
    assert done.returncode == 0, done.stderr
    assert "0x12345000: 0 of 90 frames differ" in done.stdout


def test_loops_of_the_object_live_through_the_stories_of_a_robot_on_a_desk(tmp_path):
    """Start, pause, jam, empty battery, pick-up, shutdown: the PC's targets, power and frames,
    and no joint faster than a person's hand before it plays."""
    done = run(TOOLCHAIN / "emulate", "--stories", "--at", "0x12345000")
    assert done.returncode == 0, done.stderr
    assert re.search(r"^0x12345000: 6 stories; 0 of 1\d{3} messages differ, "
                     r"0 of 2\d\d frames differ", done.stdout, re.M)
    speeds = dict(re.findall(r"^([a-z -]+): .* at most ([\d.]+) deg/s", done.stdout, re.M))
    assert list(speeds) == ["start", "pause", "jam", "empty battery", "pick-up", "shutdown"]
    assert all(50 < float(speed) <= 60 for speed in speeds.values())


def test_an_answer_of_a_story_that_is_changed_is_noticed(tmp_path):
    must(ROOT / "build/host/bin/object-stories", tmp_path / "stories", ROOT / "pycode")

    def change(index, kind, fed, answer):
        return fed, answer[:100] + bytes([answer[100] ^ 1]) + answer[101:] if index == 6 else answer

    tape = short(tmp_path / "stories", tmp_path / "short", 8, change)
    done = run(TOOLCHAIN / "emulate", "--stories", "--at", "0x10000000", "--tape", tape)
    assert done.returncode == 1
    assert "1 stories; 1 of " in done.stdout and "byte 100 of" in done.stderr


def test_players_are_distinguished_by_their_commands(tape, simple_tape, tmp_path):
    done = run(TOOLCHAIN / "emulate", "--at", "0x10000000", "--tape",
               short(simple_tape, tmp_path / "other", 12))
    assert done.returncode == 1 and "0 of" in done.stdout  # of the motion steps, which are the same
    assert re.search(r"frame 0: ", done.stderr)


def flipped(data, at):
    return data[:at] + bytes([data[at] ^ 1]) + data[at + 1:]


def test_one_other_bit_in_an_output_is_noticed(tape, tmp_path):
    changed = {"m": 2, "f": 6}

    def change(index, kind, fed, answer):
        if changed[kind.decode()] == index if kind != b"c" else False:
            answer = flipped(answer, 40)
        return fed, answer

    kinds = []
    short(tape, tmp_path / "look", 12, lambda i, k, a, b: (kinds.append(k), (a, b))[1])
    changed = {"m": kinds.index(b"m", 2), "f": kinds.index(b"f", 4)}
    done = run(TOOLCHAIN / "emulate", "--at", "0x10000000", "--tape",
               short(tape, tmp_path / "other", 12, change))
    assert done.returncode == 1
    assert re.search(r"1 of \d+ frames differ, 1 of \d+ motion steps differ", done.stdout)
    assert re.search(r"frame \d+: byte 40 of \d+", done.stderr)


def test_word_that_was_not_corrected_is_noticed(tape, tmp_path):
    """An image whose relocations are gone is as it was linked: it dies, or gives other bits."""
    from openr.elf import Elf, SHT_REL
    data = bytearray(IMAGE.read_bytes())
    elf = Elf(IMAGE)
    lost = 0
    for section in elf.sections:
        if section.type == SHT_REL and elf.sections[section.info].name == ".rodata":
            for at in range(section.offset, section.offset + section.size, 8):
                data[at + 4] = 0  # R_MIPS_NONE
                lost += 1
    for section in elf.sections:
        if section.type == SHT_REL and elf.sections[section.info].name == ".data":
            for at in range(section.offset, section.offset + section.size, 8):
                data[at + 4] = 0
                lost += 1
    assert lost > 0
    (tmp_path / "image").write_bytes(data)
    done = run(TOOLCHAIN / "emulate", "--at", "0x10000000", "--image", tmp_path / "image",
               "--tape", short(tape, tmp_path / "tape", 12))
    assert done.returncode in (1, 2) and done.stderr != ""


def test_input_that_cannot_be_read_is_noticed(tape, tmp_path):
    cut = short(tape, tmp_path / "cut", 8, lambda i, kind, fed, answer: (
        fed[:-1] if kind == b"f" else fed, answer))
    done = run(TOOLCHAIN / "emulate", "--at", "0x10000000", "--tape", cut)
    assert done.returncode == 1 and "the image could not read the input" in done.stderr


def test_tape_that_is_cut_or_none_is_named(tape, tmp_path):
    whole = short(tape, tmp_path / "whole", 8).read_bytes()
    for content, line in ((whole[:-1], "is cut off"), (whole[:-4] + b"f", "is cut off"),
                          (whole + b"\xc5" * 9, "is not what object-tape writes"),
                          (whole + b"f" + struct.pack("<II", 64_000_000, 0) + bytes(64_000_000),
                           "an input of 64000000 bytes is more than the image takes")):
        (tmp_path / "tape").write_bytes(content)
        done = run(TOOLCHAIN / "emulate", "--at", "0x10000000", "--tape", tmp_path / "tape")
        assert done.returncode == 2 and line in done.stderr
        assert done.stderr.count("\n") == 1


def test_address_where_nothing_can_lie_is_refused(tape, tmp_path):
    tape = short(tape, tmp_path / "tape", 8)
    for at in ("--at=-1", "--at=0x7ffe0000", "--at=nowhere"):
        done = run(TOOLCHAIN / "emulate", at, "--tape", tape)
        assert done.returncode == 2 and "Traceback" not in done.stderr


@pytest.mark.parametrize("arguments, line", [
    (["none.mcap"], "none.mcap"),
    (["--tape", "none"], "none"),
    (["--image", "none"], "no image none; build it with toolchain/build-object"),
    (["--image", OBJECT, "--tape", OBJECT], "so it is no image of toolchain/build-object"),
])
def test_bad_arguments_end_with_2_and_one_line(arguments, line):
    done = run(TOOLCHAIN / "emulate", *arguments)
    assert done.returncode == 2
    assert line in done.stderr and done.stderr.count("\n") == 1


def test_emulator_that_is_not_installed_is_named(tape, tmp_path):
    (tmp_path / "unicorn.py").write_text("raise ImportError('none')\n")
    done = run(TOOLCHAIN / "emulate", "--tape", tape,
               env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert done.returncode == 2
    assert done.stderr == "emulate: needs unicorn; install the Debian package python3-unicorn\n"


@pytest.fixture(scope="module")
def machine():
    import importlib.machinery
    import importlib.util
    loader = importlib.machinery.SourceFileLoader("emulate", str(TOOLCHAIN / "emulate"))
    emulate = importlib.util.module_from_spec(importlib.util.spec_from_loader("emulate", loader))
    loader.exec_module(emulate)
    return emulate.Machine(emulate.Elf(IMAGE), 0x12345000)


def bits(value):
    return struct.unpack("<Q", struct.pack("<d", value))[0]


def edge_values():
    rest = random.Random(1)
    wholes = [0.0, 0.5, 1.0, 1.5, 2.5, 0.49999999999999994, 2.0 ** 20, 2.0 ** 20 + 0.5,
              2.0 ** 20 + 0.25, 2.0 ** 21 - 0.5, 2.0 ** 21, 2.0 ** 30 + 0.5, 1e-310, 1048577.5,
              2147483646.5]
    near = [math.nextafter(x, d) for x in wholes for d in (-1e300, 1e300)]
    between = [rest.uniform(2.0 ** 20, 2.0 ** 21) for _ in range(200)]
    small = [rest.uniform(-3.0, 3.0) for _ in range(100)]
    values = wholes + near + between + small
    return values + [-value for value in values]


def maths(machine, x, y=0.0, whole=0):
    """What the functions in the image make of them (openr/emulated/Maths.cpp)."""
    data = machine.give("kelpieMaths", struct.pack("<ddq", x, y, whole))
    names = ("floor", "ceil", "fmin", "fmax", "from_whole", "to_whole", "lround")
    return dict(zip(names, struct.unpack("<QQQQQqq", data)))


def rounded(value):
    size = math.floor(abs(value))
    return int(math.copysign(size + (abs(value) - size >= 0.5), value))


def test_rounding_on_the_robots_cpu_is_that_of_the_pc(machine):
    for value in edge_values():
        made = maths(machine, value)
        assert made["floor"] == bits(math.copysign(math.floor(value), value)), value
        assert made["ceil"] == bits(math.copysign(math.ceil(value), value)), value
        assert made["lround"] == rounded(value), value


def test_floor_and_ceil_leave_what_has_no_fraction(machine):
    for value in (2.0 ** 52, -2.0 ** 53, 1e300, math.inf, -math.inf):
        made = maths(machine, value)
        assert made["floor"] == made["ceil"] == bits(value)


def test_64_bit_integers_are_those_of_the_pc(machine):
    rest = random.Random(2)
    for value in edge_values() + [rest.uniform(-9e18, 9e18) for _ in range(100)]:
        assert maths(machine, value)["to_whole"] == int(value), value
    for value in [0, 1, -1, 2 ** 62 + 1, -2 ** 63, 2 ** 53 + 1, 2 ** 53 + 3] + [
            rest.randrange(-2 ** 63, 2 ** 63) for _ in range(100)]:
        assert maths(machine, 0.0, 0.0, value)["from_whole"] == bits(float(value)), value


def test_fmin_and_fmax_pass_over_what_is_no_number(machine):
    for x, y, minimum, maximum in ((1.0, 2.0, 1.0, 2.0), (math.nan, 2.0, 2.0, 2.0),
                              (-3.0, math.nan, -3.0, -3.0), (-1.0, -2.0, -2.0, -1.0)):
        made = maths(machine, x, y)
        assert (made["fmin"], made["fmax"]) == (bits(minimum), bits(maximum))


@pytest.mark.parametrize("given", ["xyz", "a text that is longer than sixteen bytes", "q" * 3000])
def test_strings_on_the_robots_cpu_are_those_of_the_pc(machine, given):
    made = "a" + 20 * given
    made = made[:3] + given + made[10:]
    made = made[:1] + "-" + made[31:] + "!"
    made = made[2:102] + made
    assert machine.give("kelpieTexts", given.encode()).decode() == made


@pytest.mark.parametrize("program, package", [
    ("mipsel-linux-gnu-g++", "g++-mipsel-linux-gnu"), ("ninja", "ninja-build")])
def test_what_is_not_installed_is_named(tmp_path, program, package):
    import shutil
    for tool in ("bash", "dirname", "cmake", "ninja", "mipsel-linux-gnu-g++",
                 "mipsel-linux-gnu-ld"):
        if tool != program:
            (tmp_path / tool).symlink_to(shutil.which(tool))
    done = run("/bin/bash", TOOLCHAIN / "build-object", env={"PATH": str(tmp_path)})
    assert done.returncode == 2
    assert f"needs {program}; install the Debian package {package}" in done.stderr


def test_player_without_python_walks_to_the_ball_in_the_simulated_world(tmp_path):
    host = Path(os.environ.get("KELPIE", ROOT / "build/host/bin/kelpie")).parent
    with subprocess.Popen([str(host / "kelpie-world"), "--socket", str(tmp_path / "world"),
                           "--seed", "7", "--scenario", "empty-goal", "--seconds", "20",
                           "--result", str(tmp_path / "result")], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as world:
        try:
            for _ in range(200):
                if (tmp_path / "world").exists():
                    break
                time.sleep(0.05)
            done = run(host / "kelpie-agent-simple", "--socket", tmp_path / "world", "--status")
        finally:
            world.kill()
    assert done.returncode == 0, done.stderr
    distances = [int(text) for text in re.findall(r"ball (\d+) cm", done.stdout)]
    assert distances[0] > 40 and min(distances) < 15
