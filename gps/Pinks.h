// SPDX-License-Identifier: Apache-2.0
// The localiser's part in the 2004 challenge (thesis 2004 section 4.1), as the last Command asks:
// maps pink patches; or localises by the map, and by a search of the whole field while the pose is
// lost. Localising begins with the pose lost, and again whenever play begins: the robot was
// carried.
#pragma once

#include "gps/Localiser.h"

namespace kelpie::gps {

// Whether landmarks count in this frame: not while the robot localises by pinks, for then beacons
// are removed and goals are covered, and what looks like one is false.
bool landmarksCount(const FrameInput& input);

// After odometry and landmarks, before the lines.
void usePinks(const GpsIn& in, const Odometry& odometry, const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
