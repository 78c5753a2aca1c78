// SPDX-License-Identifier: Apache-2.0
// What a step of the localiser is given.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::gps {

struct GpsIn {
  const FrameInput& input;
  const Percepts& percepts;
  const CameraPose& camera;  // from which the percepts were seen
};

}  // namespace kelpie::gps
