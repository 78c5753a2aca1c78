// SPDX-License-Identifier: Apache-2.0
// Which player is in a robot's program: the behaviours in Python, or the simple one.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

// "python" or "simple", of the bytes of an AGENT.BIN that is not packed; empty when the program
// does not say.
std::string playerIn(const std::string& program);

// The bytes of a program's file, unpacked where gzip has packed it. An error when it is no whole
// gzip or none that OPEN-R loads.
Expected<std::string> programOfFile(const std::string& file);

// For people: who plays with that player and the behaviours of that folder on the stick.
std::string playerLine(const std::string& player, const std::string& folder);

}  // namespace kelpie::stick
