// SPDX-License-Identifier: Apache-2.0
// The robot writes EMON.LOG when a program of the stick dies: registers, then the words of the
// stack. Read are lines of these forms, known from a log of a crash and by the reader of StackedIt
// (Griffith University, 2003), wherever they stand:
//
//   badvaddr: $8: 0x73692067, epc:$14: 0x2260a884      exception registers, cause:$13 with them
//    gp:r28: 0x22641230                                 general registers by name and number
//   220a13f0: 22642658 800b4e08 23480008 800b4bac       four words of the stack, after [stack dump]
//
// That gp is written like ra is taken from the form of ra's line; no log was at hand that shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/stick/ElfObject.h"

namespace kelpie::stick {

struct StackWord {
  std::uint32_t at = 0;
  std::uint32_t value = 0;
};

struct EmonLog {
  std::optional<std::uint32_t> counter;     // epc: where it died
  std::optional<std::uint32_t> badAddress;  // what it could not reach
  std::optional<std::uint32_t> cause;
  std::optional<std::uint32_t> returnAddress;
  std::optional<std::uint32_t> globalPointer;
  std::vector<StackWord> stack;  // from the stack pointer up
};

// An error when there is no epc.
Expected<EmonLog> parseEmonLog(const std::string& text, const std::string& file);

// A place in the program: where it was found, and its address as linked.
struct CrashPlace {
  std::string where;          // "died in", "returns to", "0x220a13f0"
  std::uint32_t address = 0;  // of the instruction itself, for a return the call's
};

// How far from its linked address the object was, by gp or as given. An error when nothing tells.
Expected<std::uint32_t> loadOffset(const EmonLog& log, const ElfObject& object,
                                   std::optional<std::uint32_t> given);

// The places of the object's own code, the newest first. An error when it died outside of the
// object and nothing of it is on the stack.
Expected<std::vector<CrashPlace>> crashPlaces(const EmonLog& log, const ElfObject& object,
                                              std::uint32_t offset);

// "4: address error at a load or a fetch", by MIPS' exception code.
std::string causeText(std::uint32_t cause);

// "function (file:line)" of each address, by addr2line; one line when that is missing.
Expected<std::vector<std::string>> linesOf(const std::vector<CrashPlace>& places,
                                           const std::string& object);

}  // namespace kelpie::stick
