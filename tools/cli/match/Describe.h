// SPDX-License-Identifier: Apache-2.0
// What the robot believes, in words.
#pragma once

#include <string>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie::cli {

// "12.3 s  me (180, 240) 88 deg +-7 cm  ball 85 cm 12 deg left" in one line.
std::string describe(const FrameInput& input, const FrameOutput& output);

}  // namespace kelpie::cli
