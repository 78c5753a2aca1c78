// SPDX-License-Identifier: Apache-2.0
// Which player is in a robot's program: the behaviours in Python, and which, or the simple one.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

struct Player {
  std::string name;        // "python" or "simple"; empty when the program does not say
  std::string behaviours;  // of python: their number, "0a1b2c3d"
};

// Of the bytes of an AGENT.BIN that is not packed.
Player playerIn(const std::string& program);

// The bytes of a program's file, unpacked where gzip has packed it. An error when it is no whole
// gzip or none that OPEN-R loads.
Expected<std::string> programOfFile(const std::string& file);

// The number of a folder's behaviours, as toolchain/python-openr/freeze makes it: a CRC-32 of all
// .py files, each its path and a zero, then its bytes and a zero, in the order of their paths.
std::string numberOfBehaviours(const std::string& folder);

// For people: which player, and whether its behaviours are those of the folder.
std::string playerLine(const Player& player, const std::string& folder);

}  // namespace kelpie::stick
