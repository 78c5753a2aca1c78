// SPDX-License-Identifier: Apache-2.0
// Makes STICK.BIN (robot/stick/StickFormat.h) of a configuration and the stick's other files.
#pragma once

#include "robot/agent/AgentConfig.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

std::string stickBinary(const agent::AgentConfig& config, const StickTree& others);

}  // namespace kelpie::stick
