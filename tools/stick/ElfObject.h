// SPDX-License-Identifier: Apache-2.0
// What is needed of a MIPS ELF file to make sense of a crash: where its code is, what it was linked
// for, and whether an instruction calls. Of the two programs that the SDK's mkbin leaves it must be
// the first, agent.nosnap.elf: in the one of the stick addresses begin at 0, but _gp still counts
// from 0x400000. 32 bits, little-endian. Offsets that lead out of the file are refused.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::stick {

class ElfObject {
 public:
  static Expected<ElfObject> parse(std::string bytes, const std::string& file);
  // Whether it is what mkbin makes for a stick: linked, for the address 0 (openr.md section 2).
  static Status checkProgram(const std::string& bytes, const std::string& file);

  // The address of the symbol _gp.
  std::uint32_t globalPointer() const { return globalPointer_; }
  bool isCode(std::uint32_t address) const;
  // Whether a return to this address comes from a call: jalr, jal or bal two instructions before.
  bool followsCall(std::uint32_t address) const;

 private:
  struct Code {
    std::uint32_t address = 0;
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
  };
  explicit ElfObject(std::string bytes) : bytes_(std::move(bytes)) {}
  bool isMips() const;
  bool fits(std::uint64_t offset, std::uint64_t size) const;
  std::uint32_t word(std::uint32_t offset) const;
  std::uint32_t half(std::uint32_t offset) const;
  bool readCode();
  void readInstructions();
  bool readGlobalPointer();
  bool isMoved() const;
  bool findSymbol(std::uint32_t symbols, std::uint32_t names);
  const Code* instructionsAt(std::uint32_t address) const;
  std::optional<std::uint32_t> instruction(std::uint32_t address) const;
  std::string_view nameAt(std::uint32_t names, std::uint32_t offset) const;

  std::string bytes_;
  Code code_;                       // the segment; it begins with notes and tables
  std::vector<Code> instructions_;  // its sections
  std::uint32_t globalPointer_ = 0;
};

}  // namespace kelpie::stick
