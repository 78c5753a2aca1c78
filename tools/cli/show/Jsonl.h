// SPDX-License-Identifier: Apache-2.0
// One JSON object a frame: what was seen, refused and believed, and what was decided, in
// centimetres, degrees and seconds. docs/logs.md lists the keys.
#pragma once

#include <nlohmann/json.hpp>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie::cli {

nlohmann::ordered_json frameObject(const FrameInput& input, const FrameOutput& output);
const char* landmarkName(LandmarkKind kind);  // "goal_blue", "beacon_pb", ...

}  // namespace kelpie::cli
