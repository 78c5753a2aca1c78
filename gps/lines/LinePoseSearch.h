// SPDX-License-Identifier: Apache-2.0
// Finds the pose by the map of a standing robot alone, without a prior (thesis 2004 section 4.1.4):
// fits from a grid of poses over one half of the field; the best and their twins become the modes.
// Only a landmark tells which of two twins is true. Runs on request (`Command::localise`), and by
// itself while lost.
#pragma once

#include "gps/lines/LineState.h"
#include "gps/lines/LinesParams.h"
#include "gps/lines/PaintedField.h"
#include "gps/pose/PoseState.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// Once a frame, after stepMap(). Returns whether the modes were replaced: call mergeAndPrune()
// then.
bool stepLinePoseSearch(const FrameInput& input, const body::FieldDescription& field,
                        const LinesParams& params, LinesState& lines, PoseState& pose);

}  // namespace kelpie::gps
