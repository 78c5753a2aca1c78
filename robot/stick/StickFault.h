// SPDX-License-Identifier: Apache-2.0
// Why a stick is refused: a named reason, the file that it is about, and one line for people. The
// number of a reason is shown by the robot's lights (body::faultLights), so it never changes: a new
// reason takes the next number.
#pragma once

#include <string_view>

#include "robot/core/Text.h"

namespace kelpie::stick {

enum class StickFault : std::uint8_t {
  none = 0,
  missing = 1,          // no such file
  unreadable = 2,       // the medium says no
  wrongMagic = 3,       // not a file of ours
  otherVersion = 4,     // another layout of the file
  otherFieldLists = 5,  // written for another version of the program
  damagedHeader = 6,    // parts that do not fit the length
  damagedPart = 7,      // the CRC-32 of a part
  damagedWhole = 8,     // the hash of the whole
  cutShort = 9,         // ends before its length
  tooLong = 10,         // goes on after its length
  undecodable = 11,     // a bool, enum or length that cannot be
  outOfRange = 12,      // a number beyond its field's range
  otherContent = 13,    // a file of the list has another content
};
constexpr std::uint8_t kStickFaultCount = 13;  // without none

using StickPath = Text<40>;

struct StickVerdict {
  StickFault fault = StickFault::none;
  StickPath file;

  bool good() const { return fault == StickFault::none; }
};

// "the CRC-32 of a part is wrong"
std::string_view textOf(StickFault fault);

// "OPEN-R/MW/DATA/P/STICK.BIN: the CRC-32 of a part is wrong (fault 7)"
Text<120> lineOf(const StickVerdict& verdict);

}  // namespace kelpie::stick
