// SPDX-License-Identifier: Apache-2.0
// What writing a stick would change on one that is there already, in lines for people. Never shows
// what is in WLANCONF.TXT.
#pragma once

#include <string>
#include <vector>

#include "robot/agent/AgentConfig.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

// One line a file: "same", "changed", "new" or "foreign", which is another program's, its path and
// its bytes; then what the robot's reader says of the stick as it is, and where its configuration
// first differs.
std::vector<std::string> differenceLines(const StickTree& tree, const agent::AgentConfig& config,
                                         const std::string& root);

}  // namespace kelpie::stick
