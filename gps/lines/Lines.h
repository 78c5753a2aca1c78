// SPDX-License-Identifier: Apache-2.0
// Which lines are matched in a frame: the frame's own, or those of the standing robot's map, if it
// holds more.
#pragma once

#include "gps/GpsIn.h"
#include "gps/lines/LineFit.h"
#include "gps/lines/LineState.h"
#include "gps/lines/LinesParams.h"

namespace kelpie::gps {

// rad a frame; very fast when it is not finite.
double headSpeedOf(const FrameInput& input);

SeenLines linesOfFrame(const GpsIn& in, const LineUpdateParams& params);

// What of the map is used counts as used.
SeenLines linesOfFrameOrMap(const GpsIn& in, const LinesParams& params, LineMap& map);

}  // namespace kelpie::gps
