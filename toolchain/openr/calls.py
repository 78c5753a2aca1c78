# SPDX-License-Identifier: Apache-2.0
"""Who calls whom in a partially linked MIPS object, and how much stack each function takes, read
from its instructions and relocations. PIC code finds every function by the GOT, so that each
mention of a function (CALL16 or GOT16) counts as a call: that is sometimes too many and never too
few. A call by a pointer out of memory mentions nobody; its caller is in `indirect`, and who is
called must be given by a list.

The code of Python's interpreter, which lies together (object.ld), calls itself by pointers and
without end. Nobody is followed in it: all of it is one function, INTERPRETER, whose stack a list
tells, and the largest frame in it is looked at all the same."""

import bisect
import struct
from collections import defaultdict

from .elf import (R_MIPS_CALL16, R_MIPS_GOT16, R_MIPS_LO16, R_MIPS_32, SHN_UNDEF, STT_SECTION)

SP, FP = 29, 30
LW, ADDIU, SPECIAL, SW, LUI, ORI = 0x23, 0x09, 0x00, 0x2b, 0x0f, 0x0d
JR, JALR, ADDU, SUBU, OR = 0x08, 0x09, 0x21, 0x23, 0x25
RA, BEQ, REGIMM, COP1, BC1 = 31, 0x04, 0x01, 0x11, 0x08
BRANCHES = (REGIMM, BEQ, 0x05, 0x06, 0x07, 0x14, 0x15, 0x16, 0x17)
# A function of the C library takes at most this; the SDK's are leaves (openr-measured.md 4).
FOREIGN_STACK = 256
# So many moves a function's address may make between registers and frame before its call.
STEPS = 6
INTERPRETER = "Python's interpreter"
TABLE_ENDS = (0, 0xffffffff)


def signed(half):
    return half - 0x10000 if half & 0x8000 else half


class Instruction:
    """The fields of one word; which of them mean something goes by the operation."""

    def __init__(self, at, word):
        self.at = at
        self.op, self.rs, self.rt = word >> 26, word >> 21 & 31, word >> 16 & 31
        self.rd, self.function, self.immediate = word >> 11 & 31, word & 63, word & 0xffff

    def is_call(self):
        """Also a last call in place of a return; there are no jump tables."""
        return self.op == SPECIAL and (self.function == JALR or
                                       self.function == JR and self.rs != RA)

    def is_move(self):
        return self.op == SPECIAL and self.function in (ADDU, OR) and 0 in (self.rs, self.rt)

    def moved_from(self):
        return self.rs or self.rt

    def writes(self):
        """The register that is written, None if there is none."""
        if self.op == SPECIAL:
            return self.rd
        return self.rt if 0x08 <= self.op <= 0x0f or 0x20 <= self.op <= 0x27 else None

    def is_branch(self):
        return self.op in BRANCHES or self.op == COP1 and self.rs == BC1

    def is_likely(self):
        """The next instruction is done only when the branch is taken."""
        return 0x14 <= self.op <= 0x17 or self.is_branch() and self.op in (REGIMM, COP1) and (
            bool(self.rt & 2))

    def is_jump(self):
        """What is after the next instruction does not follow."""
        return (self.op == SPECIAL and self.function == JR or
                self.op == BEQ and self.rs == self.rt == 0)

    def target(self):
        return self.at + 4 + 4 * signed(self.immediate)


class Body:
    """A function's instructions and what may come before each; a branch acts one of them late."""

    def __init__(self, words):
        self.words = words
        self.before = defaultdict(list)
        for n, i in enumerate(words):
            late = words[n - 1] if n else None
            if late is not None and late.is_branch():
                self.before[(late.target() - words[0].at) // 4].append(n)
            if late is not None and late.is_likely():
                self.before[n + 1].append(n - 1)
            elif late is None or not late.is_jump():
                self.before[n + 1].append(n)

    def writers_before(self, n, register):
        """Which instructions may have written the register last; None for a caller's."""
        found, seen, waiting = set(), set(), [n]
        while waiting:
            here = waiting.pop()
            if here == 0:
                found.add(None)
            for at in self.before[here]:
                if at in seen:
                    continue
                seen.add(at)
                if self.words[at].writes() == register:
                    found.add(at)
                else:
                    waiting.append(at)
        return found


class Calls:
    def __init__(self, elf):
        self.elf = elf
        self.text = elf.section(".text")
        self.code = elf.bytes_of(self.text)
        self.functions = sorted((f for f in elf.functions() if f.section == self.text.index),
                                key=lambda f: f.value)
        self.starts = [f.value for f in self.functions]
        self.interpreter = range(elf.symbols.get("kelpiePythonBegin", 0),
                                 elf.symbols.get("kelpiePythonEnd", 0))
        self.mentioned = self.mentions()
        self.callees = defaultdict(set)
        self.stack, self.indirect, self.variable = {}, set(), set()
        self.inside = {}  # frames of the interpreter's functions
        for function in self.functions:
            self.read(function)

    def name_at(self, address):
        if address in self.interpreter:
            return INTERPRETER
        i = bisect.bisect_right(self.starts, address) - 1
        if i >= 0 and address < self.functions[i].value + max(self.functions[i].size, 4):
            return self.functions[i].name
        return None

    def word(self, at):
        return struct.unpack_from("<I", self.code, at)[0]

    def mentions(self):
        """{address of an instruction: name of the function that it mentions}"""
        found, uppers = {}, defaultdict(list)
        for relocation in self.elf.relocations_of(self.text):
            symbol = relocation.symbol
            if relocation.kind == R_MIPS_CALL16 or (relocation.kind == R_MIPS_GOT16 and
                                                    symbol.is_global):
                found[relocation.offset] = self.name_of(symbol, symbol.value)
            elif relocation.kind == R_MIPS_GOT16:
                if uppers[symbol] and uppers[symbol][-1] in found:
                    uppers[symbol].clear()  # what comes now is of another address
                uppers[symbol].append(relocation.offset)
            elif relocation.kind == R_MIPS_LO16 and uppers[symbol]:
                self.pair(found, uppers[symbol], relocation)
        return {at: name for at, name in found.items() if name}

    def pair(self, found, uppers, lower):
        """A local address stands in two halves: the upper in the GOT16 words before this LO16,
        which may share them with another."""
        for at in uppers:
            addend = ((self.word(at) & 0xffff) << 16) + signed(self.word(lower.offset) & 0xffff)
            name = self.name_of(lower.symbol, lower.symbol.value + addend & 0xffffffff)
            found[at], found[lower.offset] = found.get(at) or name, name

    def name_of(self, symbol, address):
        if symbol.section == SHN_UNDEF:
            return symbol.name
        return self.name_at(address) if symbol.section == self.text.index else None

    def read(self, function):
        body = Body([Instruction(at, self.word(at))
                     for at in range(function.value, function.value + function.size, 4)])
        words = body.words
        name = function.name
        if function.value in self.interpreter:
            self.inside[name] = max(self.inside.get(name, 0), self.frame(name, words))
            return
        self.callees[name] |= {self.mentioned[i.at] for i in words if i.at in self.mentioned}
        self.stack[name] = max(self.stack.get(name, 0), self.frame(name, words))
        if any(i.is_call() and not self.goes_by_got(body, n) for n, i in enumerate(words)):
            self.indirect.add(name)

    def frame(self, name, words):
        """Bytes by which the stack pointer goes down, all places together."""
        total, constant = 0, {}
        for i in words:
            if i.op == LUI:
                constant[i.rt] = i.immediate << 16
            elif i.op == ORI and i.rs in (0, i.rt):
                constant[i.rt] = (constant.get(i.rt, 0) if i.rs else 0) | i.immediate
            elif i.op == ADDIU and i.rt == SP and i.rs == SP:
                total += max(0, -signed(i.immediate))
            elif i.op == ADDIU and i.rs in (0, i.rt):
                constant[i.rt] = (constant.get(i.rt, 0) if i.rs else 0) + signed(i.immediate)
            elif i.op == SPECIAL and i.rd == SP and i.function in (SUBU, ADDU) and i.rs == SP:
                total += self.moved_by(name, i, constant.get(i.rt))
        return total

    def moved_by(self, name, instruction, amount):
        if amount is None:
            self.variable.add(name)
            return 0
        down = amount if instruction.function == SUBU else -amount
        return max(0, down - (1 << 32) if down >= 1 << 31 else down)

    def goes_by_got(self, body, n):
        """Whether the jump's register holds what came from the GOT on every way to it: at once, by
        other registers, or from the frame."""
        return self.holds_got(body, n, body.words[n].rs, STEPS)

    def holds_got(self, body, n, register, depth):
        writers = body.writers_before(n, register)
        return bool(writers) and all(at is not None and self.is_from_got(body, at, depth)
                                     for at in writers)

    def is_from_got(self, body, n, depth):
        i = body.words[n]
        if i.at in self.mentioned:
            return True
        if depth and i.is_move():
            return self.holds_got(body, n, i.moved_from(), depth - 1)
        if depth and i.op == LW and i.rs in (SP, FP):
            kept = [m for m, w in enumerate(body.words)
                    if w.op == SW and w.rs in (SP, FP) and w.immediate == i.immediate]
            return any(self.holds_got(body, m, body.words[m].rt, depth - 1) for m in kept)
        return False

    def constructor_table(self):
        """Names of the functions in .ctors, in its order; None where no function that is followed
        here can be identified, and nothing for a table's end."""
        section = self.elf.section(".ctors")
        if section is None:
            return []
        symbols = {relocation.offset: relocation.symbol
                   for relocation in self.elf.relocations_of(section)
                   if relocation.kind == R_MIPS_32}
        words = struct.iter_unpack("<I", self.elf.bytes_of(section)[:section.size & ~3])
        return [self.name_of(symbols[4 * i], symbols[4 * i].value + word)
                if 4 * i in symbols else None
                for i, (word,) in enumerate(words) if 4 * i in symbols or word not in TABLE_ENDS]

    def constructors(self):
        """Those that have a name: OPEN-R runs the last one first."""
        return [name for name in self.constructor_table() if name]

    def reached_from(self, name):
        """{function: its caller on the way from `name`}"""
        way, waiting = {name: None}, [name]
        while waiting:
            caller = waiting.pop()
            for callee in self.callees.get(caller, ()):
                if callee not in way:
                    way[callee] = caller
                    waiting.append(callee)
        return way

    def deepest(self):
        """(bytes, path of names); a Circle where functions call each other without end."""
        known = {}
        for name in sorted(self.stack):
            self.depth_of(name, known, [])
        if not known:
            return 0, []
        return max(known.values(), key=lambda entry: entry[0])

    def depth_of(self, name, known, way):
        if name in known:
            return known[name]
        if name in way:
            raise Circle(way[way.index(name):])
        if name not in self.stack:
            return FOREIGN_STACK, [name]
        below, path = max((self.depth_of(callee, known, way + [name])
                           for callee in self.callees[name] if callee != name),
                          key=lambda entry: entry[0], default=(0, []))
        known[name] = self.stack[name] + below, [name] + path
        return known[name]


class Circle(Exception):
    def __init__(self, names):
        super().__init__(" -> ".join(names + names[:1]))
        self.names = names
