// SPDX-License-Identifier: Apache-2.0
// What the robot's camera showed and what vision found in it, in a frame of a canvas.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/picture/Canvas.h"

namespace kelpie::match {

void drawCameraView(picture::Canvas& canvas, const picture::Frame& frame, const FrameInput& input,
                    const FrameOutput& output);

}  // namespace kelpie::match
