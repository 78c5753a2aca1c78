// SPDX-License-Identifier: Apache-2.0
// What the OPEN-R object of a robot is made of: the loops with their configuration. Made when the
// object is initialised, not by a static constructor, so that what goes wrong can be told.
#pragma once

#include <memory>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/Loops.h"

namespace kelpie::object {

// Everything as in the code: standard parameters, no calibration of one robot. 185 KB.
std::unique_ptr<agent::AgentConfig> makeConfig();

// Allocates 0.7 MB, once.
std::unique_ptr<agent::Loops> makeLoops(const agent::AgentConfig& config);

}  // namespace kelpie::object
