// SPDX-License-Identifier: Apache-2.0
// Makes STICK.BIN (robot/stick/StickFormat.h) of a configuration and the stick's other files.
#pragma once

#include "robot/agent/AgentConfig.h"
#include "robot/stick/StickFormat.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

// As the list of STICK.BIN has it.
StickFileEntry entryOf(const TreeFile& file);

std::string stickBinary(const agent::AgentConfig& config, const StickTree& others);

}  // namespace kelpie::stick
