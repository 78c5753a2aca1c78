// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/ElfObject.h"

#include <algorithm>
#include <cstring>

namespace kelpie::stick {
namespace {

// Offsets of the System V ELF header and tables, 32 bits.
constexpr std::uint32_t kHeaderBytes = 52;
constexpr std::uint32_t kProgramBytes = 32;
constexpr std::uint32_t kSectionBytes = 40;
constexpr std::uint32_t kSymbolBytes = 16;
constexpr std::uint32_t kMips = 8;
constexpr std::uint32_t kLinked = 2;  // ET_EXEC
constexpr std::uint32_t kLoad = 1;
constexpr std::uint32_t kExecutable = 1;
constexpr std::uint32_t kSymbolTable = 2;
constexpr std::uint32_t kInstructions = 4;  // SHF_EXECINSTR

}  // namespace

bool ElfObject::fits(std::uint64_t offset, std::uint64_t size) const {
  return offset <= bytes_.size() && size <= bytes_.size() - offset;
}

// 0 outside of the file.
std::uint32_t ElfObject::word(std::uint32_t offset) const {
  std::uint32_t value = 0;
  if (fits(offset, sizeof value)) std::memcpy(&value, bytes_.data() + offset, sizeof value);
  return value;
}

std::uint32_t ElfObject::half(std::uint32_t offset) const { return word(offset) & 0xFFFFU; }

bool ElfObject::isMips() const {
  return fits(0, kHeaderBytes) && word(0) == 0x464C457FU && half(4) == 0x0101U && half(18) == kMips;
}

Status ElfObject::checkProgram(const std::string& bytes, const std::string& file) {
  ElfObject object(bytes);
  if (!object.isMips()) return Error{file + ": is neither a MIPS program nor gzip of one"};
  if (object.half(16) != kLinked || !object.readCode())
    return Error{file + ": is not linked; toolchain/link-object makes the program of it"};
  if (object.code_.address != 0)
    return Error{file + ": is a program of another system, not one that OPEN-R loads"};
  return Done{};
}

Expected<ElfObject> ElfObject::parse(std::string bytes, const std::string& file) {
  ElfObject object(std::move(bytes));
  if (!object.isMips()) return Error{file + ": is not a MIPS ELF file of 32 bits, little-endian"};
  if (!object.readCode()) return Error{file + ": holds no code with addresses; is it linked?"};
  object.readInstructions();
  if (!object.readGlobalPointer())
    return Error{file + ": has no symbol _gp; take the ELF file before it was stripped"};
  if (object.isMoved())
    return Error{file +
                 ": was moved to address 0 and its _gp was not; take the agent.nosnap.elf "
                 "beside that AGENT.BIN"};
  return object;
}

bool ElfObject::readCode() {
  const std::uint32_t table = word(28);
  for (std::uint32_t i = 0; i < half(44); ++i) {
    const std::uint32_t at = table + i * kProgramBytes;
    if (word(at) != kLoad || (word(at + 24) & kExecutable) == 0) continue;
    code_ = {word(at + 8), word(at + 4), word(at + 16)};
    return code_.size > 0 && fits(code_.offset, code_.size);
  }
  return false;
}

void ElfObject::readInstructions() {
  const std::uint32_t table = word(32);
  for (std::uint32_t i = 0; i < half(48); ++i) {
    const std::uint32_t at = table + i * kSectionBytes;
    if ((word(at + 8) & kInstructions) == 0 || !fits(word(at + 16), word(at + 20))) continue;
    instructions_.push_back({word(at + 12), word(at + 16), word(at + 20)});
  }
}

bool ElfObject::readGlobalPointer() {
  const std::uint32_t table = word(32);
  for (std::uint32_t i = 0; i < half(48); ++i) {
    const std::uint32_t at = table + i * kSectionBytes;
    if (word(at + 4) != kSymbolTable) continue;
    return findSymbol(at, table + word(at + 24) * kSectionBytes);
  }
  return false;
}

// _gp is 32752 bytes behind the start of the GOT, which is in the file.
bool ElfObject::isMoved() const {
  constexpr std::uint32_t kBehindGot = 0x7ff0;
  return code_.address == 0 && globalPointer_ > code_.size + kBehindGot;
}

std::string_view ElfObject::nameAt(std::uint32_t names, std::uint32_t offset) const {
  const std::uint64_t at = std::uint64_t{word(names + 16)} + offset;
  if (!fits(at, 1)) return "";
  const std::string_view rest = std::string_view(bytes_).substr(at);
  return rest.substr(0, rest.find('\0'));
}

bool ElfObject::findSymbol(std::uint32_t symbols, std::uint32_t names) {
  const std::uint32_t offset = word(symbols + 16);
  const std::uint32_t size = word(symbols + 20);
  if (!fits(offset, size)) return false;
  for (std::uint32_t at = offset; at + kSymbolBytes <= offset + size; at += kSymbolBytes) {
    if (nameAt(names, word(at)) != "_gp") continue;
    globalPointer_ = word(at + 4);
    return true;
  }
  return false;
}

const ElfObject::Code* ElfObject::instructionsAt(std::uint32_t address) const {
  const auto holds = [address](const Code& section) {
    return address >= section.address && address - section.address < section.size;
  };
  const auto found = std::find_if(instructions_.begin(), instructions_.end(), holds);
  return address % 4 != 0 || found == instructions_.end() ? nullptr : &*found;
}

bool ElfObject::isCode(std::uint32_t address) const { return instructionsAt(address) != nullptr; }

std::optional<std::uint32_t> ElfObject::instruction(std::uint32_t address) const {
  const Code* section = instructionsAt(address);
  if (section == nullptr) return std::nullopt;
  return word(section->offset + (address - section->address));
}

bool ElfObject::followsCall(std::uint32_t address) const {
  const auto before = instruction(address - 8);
  if (!before) return false;
  const std::uint32_t operation = *before >> 26U;
  const bool jalr = operation == 0 && (*before & 0x3FU) == 9;
  const bool bal = operation == 1 && (*before >> 16U & 0x1EU) == 0x10;  // bltzal, bgezal
  return jalr || bal || operation == 3;
}

}  // namespace kelpie::stick
