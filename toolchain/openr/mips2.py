# SPDX-License-Identifier: Apache-2.0
"""Which 32-bit words are instructions that the robot's object may hold: those of MIPS II without
those of a kernel, of the OS's calls and of coprocessors that are not there. A disassembler does not
tell: it gives a word of a later processor the name of an older instruction of the same number (pref
is an R6000's lwc3), or prints an unknown function of the floating point unit as c1.

The tables hold what there is, by opcode and function, with the bits that must be zero: a later
processor put another instruction where they are not (rotr is srl with rs = 1, and the conditions of
MIPS IV are three bits of c.lt.d). Floating point registers go in pairs, so that arithmetic has even
ones only (-mfp32)."""

RS, RT, RD, SA = 31 << 21, 31 << 16, 31 << 11, 31 << 6
SPECIAL, REGIMM, COP0, COP1, COP2, COP3 = 0x00, 0x01, 0x10, 0x11, 0x12, 0x13
ODD_FT, ODD_FS, ODD_FD = 1 << 16, 1 << 11, 1 << 6

# j jal beq bne, blez bgtz, addi addiu slti sltiu andi ori xori lui; beql bnel, blezl bgtzl; lb lh
# lwl lw lbu lhu lwr, sb sh swl sw, swr; ll sc; lwc1 swc1, ldc1 sdc1.
OPCODES = {
    0x02: 0, 0x03: 0, 0x04: 0, 0x05: 0, 0x06: RT, 0x07: RT,
    0x08: 0, 0x09: 0, 0x0a: 0, 0x0b: 0, 0x0c: 0, 0x0d: 0, 0x0e: 0, 0x0f: RS,
    0x14: 0, 0x15: 0, 0x16: RT, 0x17: RT,
    0x20: 0, 0x21: 0, 0x22: 0, 0x23: 0, 0x24: 0, 0x25: 0, 0x26: 0,
    0x28: 0, 0x29: 0, 0x2a: 0, 0x2b: 0, 0x2e: 0,
    0x30: 0, 0x38: 0, 0x31: 0, 0x39: 0, 0x35: ODD_FT, 0x3d: ODD_FT}
# sll srl sra, sllv srlv srav; jr jalr; break sync; mfhi mthi mflo mtlo; mult multu div divu; add
# addu sub subu and or xor nor; slt sltu; tge tgeu tlt tltu teq tne.
SPECIALS = {
    0x00: RS, 0x02: RS, 0x03: RS, 0x04: SA, 0x06: SA, 0x07: SA,
    0x08: RT | RD | SA, 0x09: RT | SA, 0x0d: 0, 0x0f: RS | RT | RD | SA,
    0x10: RS | RT | SA, 0x11: RT | RD | SA, 0x12: RS | RT | SA, 0x13: RT | RD | SA,
    0x18: RD | SA, 0x19: RD | SA, 0x1a: RD | SA, 0x1b: RD | SA,
    0x20: SA, 0x21: SA, 0x22: SA, 0x23: SA, 0x24: SA, 0x25: SA, 0x26: SA, 0x27: SA,
    0x2a: SA, 0x2b: SA,
    0x30: 0, 0x31: 0, 0x32: 0, 0x33: 0, 0x34: 0, 0x36: 0}
# bltz bgez bltzl bgezl, tgei tgeiu tlti tltiu, teqi tnei, bltzal bgezal bltzall bgezall
REGIMMS = {0x00, 0x01, 0x02, 0x03, 0x08, 0x09, 0x0a, 0x0b, 0x0c, 0x0e, 0x10, 0x11, 0x12, 0x13}
# mfc1 and mtc1, and of cfc1 and ctc1 the two registers that the unit has, 0 and 31.
MOVES, CONTROLS, BRANCH = (0x00, 0x04), (0x02, 0x06), 0x08
SINGLE, DOUBLE, WORD = 0x10, 0x11, 0x14
# By format: functions of two operands (add sub mul div) and of one (sqrt abs mov neg, round.w
# trunc.w ceil.w floor.w, cvt.s cvt.d cvt.w). Those from 0x30 on compare.
BINARY = {0x00, 0x01, 0x02, 0x03}
UNARY = {0x04, 0x05, 0x06, 0x07, 0x0c, 0x0d, 0x0e, 0x0f, 0x24}
CONVERSIONS = {SINGLE: UNARY | {0x21}, DOUBLE: UNARY | {0x20}, WORD: {0x20, 0x21}}
COMPARE = 0x30
FORMATS = {SINGLE: ".s", DOUBLE: ".d", WORD: ".w", 0x15: ".l", 0x16: ".ps"}

# What is refused most likely, by its name; the rest is shown by its numbers.
FOREIGN_OPCODES = {COP0: "of the kernel's coprocessor 0", COP2: "of coprocessor 2",
                   COP3: "of coprocessor 3", 0x1c: "SPECIAL2 of MIPS32", 0x1f: "SPECIAL3 of MIPS32",
                   0x33: "pref", 0x2f: "cache", 0x37: "ld", 0x3f: "sd", 0x27: "lwu"}
FOREIGN_SPECIALS = {0x01: "movf or movt", 0x0a: "movz", 0x0b: "movn", 0x0c: "syscall",
                    0x2c: "dadd", 0x2d: "daddu"}
FOREIGN_FUNCTIONS = {0x08: "round.l", 0x09: "trunc.l", 0x0a: "ceil.l", 0x0b: "floor.l",
                     0x11: "movf or movt", 0x12: "movz", 0x13: "movn", 0x15: "recip",
                     0x16: "rsqrt", 0x25: "cvt.l"}


def fault(word):
    """None, or what the word is instead of an instruction of the object."""
    opcode = word >> 26
    if opcode == SPECIAL:
        return by_table(word, SPECIALS, word & 63, FOREIGN_SPECIALS, "SPECIAL function")
    if opcode == REGIMM:
        kind = word >> 16 & 31
        return None if kind in REGIMMS else f"REGIMM function {kind:#04x}"
    if opcode == COP1:
        return floating(word)
    return by_table(word, OPCODES, opcode, FOREIGN_OPCODES, "opcode")


def by_table(word, table, number, foreign, kind):
    if number not in table:
        return foreign.get(number, f"{kind} {number:#04x}")
    return None if word & table[number] == 0 else f"{kind} {number:#04x} with a field that is not 0"


def floating(word):
    kind = word >> 21 & 31
    if kind in MOVES or kind in CONTROLS:
        register = word >> 11 & 31
        good = word & 0x7ff == 0 and (kind in MOVES or register in (0, 31))
        return None if good else f"COP1 move {kind:#04x} with a field that is not 0"
    if kind == BRANCH:
        return None if word & 7 << 18 == 0 else "a branch by a condition other than $fcc0"
    return arithmetic(word, kind)


def arithmetic(word, form):
    function = word & 63
    if form in (SINGLE, DOUBLE) and function >= COMPARE:
        if word & SA:
            return f"a comparison{FORMATS[form]} with a condition other than $fcc0"
        odd = ODD_FT | ODD_FS
    elif form in (SINGLE, DOUBLE) and function in BINARY:
        odd = ODD_FT | ODD_FS | ODD_FD
    elif function in CONVERSIONS.get(form, ()):
        odd = RT | ODD_FS | ODD_FD  # no second operand
    else:
        name = FOREIGN_FUNCTIONS.get(function, f"function {function:#04x}")
        return f"{name}{FORMATS.get(form, f' of format {form:#04x}')}"
    return None if word & odd == 0 else "floating point arithmetic with an odd register"


class Decoder:
    """Says of many words which are faults; a program repeats most of its words."""

    def __init__(self):
        self.known = {}

    def __call__(self, word):
        if word not in self.known:
            self.known[word] = fault(word)
        return self.known[word]
