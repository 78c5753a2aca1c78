# SPDX-License-Identifier: Apache-2.0
"""What toolchain/check-object and toolchain/emulate read of a 32-bit little-endian MIPS ELF file:
sections, symbols, and relocations whose addend stands in the place that is corrected (o32 has no
other kind)."""

import struct
from collections import namedtuple

R_MIPS_32, R_MIPS_HI16, R_MIPS_LO16, R_MIPS_GOT16 = 2, 5, 6, 9
R_MIPS_CALL16, R_MIPS_GPREL32 = 11, 12
# The MIPS psABI's numbers; those not named here are shown by number.
RELOCATIONS = {0: "R_MIPS_NONE", 1: "R_MIPS_16", 2: "R_MIPS_32", 3: "R_MIPS_REL32", 4: "R_MIPS_26",
               5: "R_MIPS_HI16", 6: "R_MIPS_LO16", 7: "R_MIPS_GPREL16", 8: "R_MIPS_LITERAL",
               9: "R_MIPS_GOT16", 10: "R_MIPS_PC16", 11: "R_MIPS_CALL16", 12: "R_MIPS_GPREL32",
               37: "R_MIPS_JALR", 248: "R_MIPS_PC32"}
SHT_SYMTAB, SHT_NOBITS, SHT_REL = 2, 8, 9
SHF_WRITE, SHF_ALLOC, SHF_EXECINSTR = 1, 2, 4
STT_FUNC, STT_SECTION, SHN_UNDEF = 2, 3, 0
# Memory that has no section before the last link; the second is MIPS' small one.
SHN_COMMON, SHN_MIPS_SCOMMON = 0xfff2, 0xff03

Symbol = namedtuple("Symbol", "name value size kind is_global section")
Relocation = namedtuple("Relocation", "offset kind symbol")


class NotElf(Exception):
    pass


class Section:
    def __init__(self, index, header, name):
        (_, self.type, self.flags, self.address, self.offset, self.size, self.link, self.info, _,
         _) = header
        self.index, self.name = index, name

    @property
    def has_bytes(self):
        return self.type != SHT_NOBITS


class Elf:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        if self.data[:7] != b"\x7fELF\x01\x01\x01" or self.data[18:20] != b"\x08\x00":
            raise NotElf(f"{path}: no 32-bit little-endian MIPS ELF file")
        try:
            self.sections = self.read_sections()
            self.symbol_list = self.read_symbols()
        except struct.error:
            raise NotElf(f"{path}: cut off") from None
        self.symbols = {symbol.name: symbol.value for symbol in self.symbol_list
                        if symbol.section != SHN_UNDEF and symbol.kind != STT_SECTION}

    @property
    def is_partial(self):
        """ET_REL: not yet linked for an address."""
        return self.data[16:18] == b"\x01\x00"

    def read_sections(self):
        table, = struct.unpack_from("<I", self.data, 32)
        size, count, names = struct.unpack_from("<HHH", self.data, 46)
        headers = [struct.unpack_from("<10I", self.data, table + i * size) for i in range(count)]
        return [Section(i, header, self.text(headers[names][4] + header[0]))
                for i, header in enumerate(headers)]

    def text(self, at):
        return self.data[at:self.data.index(b"\0", at)].decode()

    def bytes_of(self, section):
        return self.data[section.offset:section.offset + section.size]

    def section(self, name):
        for section in self.sections:
            if section.name == name:
                return section
        return None

    def allocated(self):
        return [section for section in self.sections if section.flags & SHF_ALLOC and section.size]

    def writable(self):
        return [section for section in self.allocated() if section.flags & SHF_WRITE]

    def executable(self):
        return [section for section in self.allocated() if section.flags & SHF_EXECINSTR]

    def common(self):
        return [symbol for symbol in self.symbol_list
                if symbol.section in (SHN_COMMON, SHN_MIPS_SCOMMON)]

    def instructions(self):
        """(section, address of each word of code in it, the word)"""
        for section in self.executable():
            words = struct.iter_unpack("<I", self.bytes_of(section)[:section.size & ~3])
            for i, (word,) in enumerate(words):
                yield section, section.address + 4 * i, word

    def read_symbols(self):
        """In the order of the file: relocations tell a symbol by its number."""
        for table in self.sections:
            if table.type == SHT_SYMTAB:
                return [self.symbol(table, i) for i in range(table.size // 16)]
        return []

    def symbol(self, table, i):
        name, value, size, info, _, section = struct.unpack_from("<IIIBBH", self.data,
                                                                 table.offset + 16 * i)
        return Symbol(self.text(self.sections[table.link].offset + name), value, size, info & 15,
                      info >> 4 != 0, section)

    def relocations_of(self, section):
        for table in self.sections:
            if table.type == SHT_REL and table.info == section.index:
                for offset, info in struct.iter_unpack("<II", self.bytes_of(table)):
                    yield Relocation(offset, info & 255, self.symbol_list[info >> 8])

    def functions(self):
        return [symbol for symbol in self.symbol_list
                if symbol.kind == STT_FUNC and symbol.section != SHN_UNDEF]

    def function_in(self, section, address):
        """Name of the function that a place of a section lies in."""
        for symbol in self.functions():
            if symbol.section == section.index and (
                    symbol.value <= address < symbol.value + max(symbol.size, 4)):
                return symbol.name
        return "no function"

    def function_at(self, address):
        """Name of the function that an address of a linked file lies in."""
        for symbol in self.functions():
            if symbol.value <= address < symbol.value + max(symbol.size, 4):
                return symbol.name
        return "no function"
