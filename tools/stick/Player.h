// SPDX-License-Identifier: Apache-2.0
// Which player is in a robot's program: the behaviours in Python, or the simple one.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

// "python" or "simple", of an AGENT.BIN, which gzip may have packed. An error when it is none that
// OPEN-R loads, or no agent of ours: then nothing in it names a player.
Expected<std::string> playerOfFile(const std::string& file);

// For people: who plays with that player and the behaviours of that folder on the stick.
std::string playerLine(const std::string& player, const std::string& folder);

}  // namespace kelpie::stick
