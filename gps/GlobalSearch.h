// SPDX-License-Identifier: Apache-2.0
// Finds the pose by the map of a standing robot alone, from nowhere (thesis 2004 section 4.1.4):
// blunt fits from many starts over one half of the field, some a frame so that none is dropped; the
// best poses, fitted sharply, and their twins become the modes. Which of two twins is true only a
// landmark tells. Asked for by `Command::localise`, or begun by itself while lost.
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "robot/core/FrameInput.h"

namespace kelpie::gps {

// Once a frame, after stepMap(). Returns whether the modes were replaced: call mergeAndPrune()
// then.
bool stepSearch(const FrameInput& input, const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
