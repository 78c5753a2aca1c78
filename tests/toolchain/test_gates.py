# SPDX-License-Identifier: Apache-2.0
"""Gates of check-object that no disassembler and no linker has behind it: the instructions by their
words, the memory, what static constructors reach and in which order they run, and the names of the
link with the SDK's headers. Each refuses the fault that it is for. Run by ctest, which builds the
object."""

import re

import pytest

from test_object import OBJECT, TOOLCHAIN, compiled, linked, must, refusal, run
from openr import mips2
from openr.calls import Calls
from openr.elf import Elf


def assembled(folder, words, level):
    source = (f".text\n.globl root\n.ent root\nroot:\n.set noreorder\n.set noat\n.set {level}\n"
              f"{words}\njr $31\nnop\n.end root\n")
    return compiled(folder, source, suffix="s")


@pytest.mark.parametrize("level, text, reported", [
    ("mips3", "round.l.d $f0, $f2", "round.l.d"),
    ("mips3", "cvt.l.d $f0, $f2", "cvt.l.d"),
    ("mips4", "c.lt.d $fcc1, $f0, $f2", "a comparison.d with a condition other than $fcc0"),
    ("mips4", "1: bc1t $fcc2, 1b", "a branch by a condition other than $fcc0"),
    ("mips4", "pref 0, 0($4)", "pref"),
    ("mips2", "syscall", "syscall"),
    ("mips2", "mfc0 $2, $12", "of the kernel's coprocessor 0"),
    ("mips2", "lwc2 $2, 0($4)", "opcode 0x32"),
    ("mips4", "movz $2, $3, $4", "movz"),
    ("mips4", "movt $2, $3, $fcc1", "movf or movt"),
    ("mips4", "movn.s $f0, $f2, $4", "movn.s"),
    ("mips4", "madd.d $f0, $f2, $f4, $f6", "of coprocessor 3"),
    ("mips4", "recip.s $f0, $f2", "recip.s"),
    ("mips3", "dsll $2, $3, 4", "SPECIAL function 0x38"),
    ("mips32", "mul $2, $3, $4", "SPECIAL2 of MIPS32"),
    ("mips32r2", "ext $2, $3, 4, 5", "SPECIAL3 of MIPS32"),
    ("mips32r2", "rotr $2, $3, 4", "SPECIAL function 0x02 with a field that is not 0"),
    ("mips32r2", "rotrv $2, $3, $4", "SPECIAL function 0x06 with a field that is not 0"),
    ("mips32r2", "mfhc1 $2, $f2", "function 0x00 of format 0x03"),
    ("mips2", ".word 0x46031040", "floating point arithmetic with an odd register")])
def test_word_that_is_no_instruction_of_the_object_is_refused(tmp_path, level, text, reported):
    found = refusal(assembled(tmp_path, text, level))
    assert found == {"instruction_set": [f"root has 1 instructions beyond MIPS II: {reported}"]}


# One of each instruction that the tables have, but for jumps and branches.
OWN = """lb lbu lh lhu lw lwl lwr ll sb sh sw swl swr sc: $2, 4($3)
lwc1 swc1 ldc1 sdc1: $f2, 4($3)
addi addiu slti sltiu andi ori xori: $2, $3, 5
add addu sub subu and or xor nor slt sltu sllv srlv srav: $2, $3, $4
sll srl sra: $2, $3, 4
mult multu tge tgeu tlt tltu teq tne: $2, $3
div divu: $0, $2, $3
tgei tgeiu tlti tltiu teqi tnei: $2, 5
mfhi mflo mthi mtlo: $2
mfc1 mtc1: $2, $f4
cfc1 ctc1: $2, $31
add.s sub.s mul.s div.s add.d sub.d mul.d div.d: $f2, $f4, $f6
sqrt.s abs.s mov.s neg.s round.w.s trunc.w.s ceil.w.s floor.w.s cvt.d.s cvt.w.s: $f2, $f4
sqrt.d abs.d mov.d neg.d round.w.d trunc.w.d ceil.w.d floor.w.d cvt.s.d cvt.w.d: $f2, $f4
cvt.s.w cvt.d.w: $f2, $f4
c.eq.s c.lt.d c.le.d c.un.s c.ngt.d: $f2, $f4
lui: $2, 5
break sync: """
JUMPS = """beq $2, $3, root; bnel $2, $3, root; beql $2, $3, root; blez $2, root; bgtzl $2, root
bltz $2, root; bgezall $2, root; bltzal $2, root; bc1f root; bc1tl root; jalr $31, $25"""


def test_every_instruction_of_mips_ii_is_let_through(tmp_path):
    lines = [f"{name} {operands}" for line in OWN.splitlines()
             for names, operands in [line.split(":")] for name in names.split()]
    jumps = [line.strip() + "\nnop" for line in JUMPS.replace("\n", ";").split(";")]
    path = assembled(tmp_path, "\n".join(lines + jumps), "mips2")
    words = [word for _, _, word in Elf(path).instructions()]
    assert len(words) >= len(lines) + 2 * len(jumps)
    assert [hex(word) for word in words if mips2.fault(word)] == []


def test_object_takes_what_the_budget_of_memory_grants():
    said = must(TOOLCHAIN / "check-object", OBJECT)
    size = int(re.search(r"(\d+) bytes of data, heap and stack", said)[1])
    assert 7_000_000 < size < 8_000_000


def test_memory_over_the_budget_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, 'char much[200 << 20]; '
                             'extern "C" char* root() { return much; }'))
    assert list(found) == ["memory"]
    assert re.match(r"takes 2152\d{5} bytes of data, heap and stack, at most 8000000 ",
                    found["memory"][0])


@pytest.mark.parametrize("section", [".comm", ".lcomm"])
def test_memory_without_a_section_counts_too(tmp_path, section):
    text = (f"{section} big, 209715200\n.text\n.globl root\n.ent root\n"
            "root: lw $2, %got(big)($28)\njr $31\nnop\n.end root\n")
    found = refusal(compiled(tmp_path, text, suffix="s"))
    assert list(found) == ["memory"]
    assert re.match(r"takes 2152\d{5} bytes", found["memory"][0])


@pytest.mark.parametrize("source, reported", [
    ('extern "C" void* fopen(const char*, const char*); void* file = fopen("/MS/A.TXT", "r"); '
     'extern "C" void* root() { return file; }', "reaches a file or a stream (fopen)"),
    ('extern "C" void* fopen(const char*, const char*); __attribute__((noinline)) static void* '
     'deep(int n) { return fopen("/MS/A.TXT", n > 3 ? "r" : "w"); } '
     '__attribute__((noinline)) static void* in(int n) { return n ? deep(n + 1) : 0; } '
     'int kind = 4; void* file = in(kind); extern "C" void* root() { return file; }',
     "reaches a file or a stream (fopen)"),
    ('#include <iostream>\nextern "C" void root() {}', "(_ZNSt8ios_base4InitC1Ev)"),
    ('#include <fstream>\nstd::ofstream file("/MS/A.TXT"); '
     'extern "C" void* root() { return &file; }',
     "basic_ofstream")])
def test_static_constructor_that_reaches_a_file_or_a_stream_is_refused(tmp_path, source, reported):
    found = refusal(compiled(tmp_path, source, "-std=c++17"))
    assert any("static constructor _GLOBAL__sub_I" in line and reported in line
               for line in found["constructors"])


FOPEN = 'extern "C" void* fopen(const char*, const char*); void* file; '


def test_code_that_lies_in_another_section_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, FOPEN + '__attribute__((constructor, section("fast"))) '
                             'static void early() { file = fopen("a", "r"); } '
                             'extern "C" void* root() { return file; }'))
    assert found["code_sections"] == ["has code in fast, where nobody follows it"]
    assert found["constructors"] == ["has a static constructor that is no function of .text"]


@pytest.mark.parametrize("word", ["early + 64", "0x1234"])
def test_static_constructor_that_no_function_is_is_refused(tmp_path, word):
    text = (".text\n.globl root\n.ent root\nroot: jr $31\nnop\n.end root\n"
            f".ent early\nearly: jr $31\nnop\n.end early\n"
            f'.section .ctors, "aw"\n.word 0xffffffff, {word}, 0\n')
    found = refusal(compiled(tmp_path, text, suffix="s"))
    assert found == {"constructors": ["has a static constructor that is no function of .text"]}


# A name of the list, with a call by a pointer of its own.
BY_POINTER = """
extern "C" void* fopen(const char*, const char*);
typedef void* (*Open)(const char*, const char*);
extern Open table[];
Open table[] = {fopen};
namespace kelpie { namespace stick {
struct StdioFiles { __attribute__((noinline)) static int close(int n) { return n * 3; } };
struct StickReader {
  __attribute__((noinline)) static void* open(int n) { return table[n]("a", "r"); }
};
} }
using namespace kelpie::stick;
int kind;
"""


def test_call_by_a_pointer_of_a_listed_name_to_nobody_of_its_list_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, BY_POINTER + 'extern "C" void* root(int n) { '
                             'return StickReader::open(n); }'))
    assert list(found) == ["indirect_calls"]
    assert "none whom openr/calls.txt has for it is there" in found["indirect_calls"][0]
    listed = compiled(tmp_path, BY_POINTER + 'extern "C" void* root(int n) { '
                      'return StickReader::open(StdioFiles::close(n)); }')
    assert run(TOOLCHAIN / "check-object", listed).returncode == 0


def test_static_constructor_that_calls_by_a_pointer_is_refused(tmp_path):
    found = refusal(compiled(tmp_path, BY_POINTER + "void* file = StickReader::open(kind); "
                             'extern "C" int root(int n) { return StdioFiles::close(n); }'))
    assert list(found) == ["constructors"]
    assert re.match(r"the static constructor _GLOBAL__sub_I\S* calls by a pointer "
                    r"\(\S+StickReader4open", found["constructors"][0])


PRIORITIES = """
extern "C" void* memset(void*, int, unsigned);
struct Step { Step(int n) { memset(this, n, sizeof *this); } int made; };
Step plain(1);
__attribute__((init_priority(300))) Step second(2);
__attribute__((init_priority(101))) Step first(3);
extern "C" int root() { return plain.made + second.made + first.made; }"""


def test_constructors_run_by_their_priorities(tmp_path):
    path = compiled(tmp_path, PRIORITIES)
    assert run(TOOLCHAIN / "check-object", path).returncode == 0
    last_first = Calls(Elf(path)).constructors()[::-1]
    assert [name[:20] for name in last_first] == [
        "_GLOBAL__sub_I.00101", "_GLOBAL__sub_I.00300", "_GLOBAL__sub_I_own.c"]


@pytest.mark.parametrize("order, reported", [
    ("KEEP(*(SORT(.init_array.*))) KEEP(*(.init_array))", [(300, 101), (65535, 300)]),
    ("KEEP(*(.init_array)) KEEP(*(SORT(.init_array.*)))", [(300, 101)])])
def test_constructors_in_another_order_are_refused(tmp_path, order, reported):
    compiled(tmp_path, PRIORITIES)
    text = (TOOLCHAIN / "openr/object.ld").read_text()
    (tmp_path / "other.ld").write_text(
        re.sub(r"\.ctors 0 :\s*\{.*?\n  \}", f".ctors 0 : {{ {order} }}", text, flags=re.S))
    found = refusal(linked(tmp_path, tmp_path / "other.ld"))
    lines = "\n".join(found.pop("constructor_order"))
    runs = re.findall(r"of priority (\d+) before \S+ of priority (\d+)", lines)
    assert not found and [(int(sooner), int(later)) for sooner, later in runs] == reported


def test_constructors_in_a_table_that_nobody_runs_are_refused(tmp_path):
    compiled(tmp_path, PRIORITIES)
    text = (TOOLCHAIN / "openr/object.ld").read_text()
    (tmp_path / "other.ld").write_text(text.replace("KEEP(*(.init_array .ctors))", ""))
    found = refusal(linked(tmp_path, tmp_path / "other.ld"))
    assert "constructors in .init_array, which OPEN-R does not run" in found["constructor_order"][0]


def rows():
    lines = (TOOLCHAIN / "openr/undefined.txt").read_text().splitlines()
    return [line.split() for line in lines if line and line[0] != "#"]


def wanting(folder, names):
    words = "".join(f".word {name}\n" for name in names)
    source = (f".text\n.globl root\n.ent root\nroot: lw $2, %got(all)($28)\njr $31\n.end root\n"
              f".data\n.globl all\nall:\n{words}")
    return compiled(folder, source, suffix="s")


def test_every_name_that_the_link_with_the_sdk_wants_is_let_through(tmp_path):
    names = [name for name, library in rows() if library not in ("nobody", "linker")]
    assert len(names) >= 71
    done = run(TOOLCHAIN / "check-object", wanting(tmp_path, names))
    assert done.returncode == 0 and f" {len(names)} names of others" in done.stdout, done.stderr


@pytest.mark.parametrize("name", [
    "_Z7osyslogiPKcz", "_ZN9OObserver11AssertReadyEv", "_ZNSo5flushEv",
    "_ZTVSt13basic_filebufIcSt11char_traitsIcEE"])
def test_name_that_it_does_not_want_is_refused(tmp_path, name):
    found = refusal(wanting(tmp_path, [name]))
    assert len(found["undefined_names"]) == 1
    assert "is not in openr/undefined.txt" in found["undefined_names"][0]


def test_name_that_is_only_left_over_is_looked_at_too(tmp_path):
    left = ('extern "C" void {0}(); extern "C" void gone() {{ {0}(); }} '
            'extern "C" int root() {{ return 3; }}')
    found = refusal(compiled(tmp_path, left.format("printf")))
    assert found == {"undefined_names": ["names printf, which is not in openr/undefined.txt"]}
    done = run(TOOLCHAIN / "check-object", compiled(tmp_path, left.format("_ZNSo5flushEv")))
    assert done.returncode == 0, done.stderr
