// SPDX-License-Identifier: Apache-2.0
// A frame's field lines in the order of their use: the standing robot's map, the search on it, the
// update by the map or the frame, whichever holds more points.
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "robot/core/FrameInput.h"
#include "robot/core/Percepts.h"

namespace kelpie::gps {

// rad a frame; very fast when it is not finite.
double headSpeedOf(const FrameInput& input);

// Not after a scrum until the pose is confirmed.
bool linesUsable(const GpsParams& params, const GpsState& state);

// Returns whether modes were changed: call mergeAndPrune() then.
bool stepLines(const FrameInput& input, const Percepts& percepts, const GpsParams& params,
               GpsState& state);

}  // namespace kelpie::gps
