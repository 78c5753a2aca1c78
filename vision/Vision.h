// SPDX-License-Identifier: Apache-2.0
// Vision: one image and the camera's pose become Percepts. Pure but for VisionState, which keeps
// work buffers and no memory of earlier images.
#pragma once

#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"
#include "vision/VisionParams.h"
#include "vision/VisionState.h"

namespace kelpie::vision {

struct VisionIn {
  const FrameInput& input;
  const BodyState& body;
};

// Writes over what `out` held. Two copies of the Percepts would be a fiftieth of the stage.
void stepInto(Percepts& out, const VisionIn& in, const VisionParams& params, VisionState& state);

Percepts step(const VisionIn& in, const VisionParams& params, VisionState& state);

}  // namespace kelpie::vision
