// SPDX-License-Identifier: Apache-2.0
// Reads a robot's log frame by frame: what came into each and what the agent made of it.
#pragma once

#include <functional>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie::experiments {

using AgentFrame = std::function<void(const FrameInput& input, const FrameOutput& output)>;

// An output whose input cannot be read is left out. An error is the log's.
Status eachAgentFrame(const std::string& log, const AgentFrame& frame);

}  // namespace kelpie::experiments
