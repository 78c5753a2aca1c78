// SPDX-License-Identifier: Apache-2.0
// The localiser's part in the 2004 challenge (thesis 2004 section 4.1), as the last Command asks:
// maps pink patches; or localises by the map, and by a search of the whole field while the pose is
// lost. Localising begins with the pose lost, and again whenever play begins: the robot was
// carried.
#pragma once

#include "gps/GpsIn.h"
#include "gps/pinks/PinkContext.h"
#include "gps/pinks/PinkState.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

struct PinksIn {
  const GpsIn& frame;
  const Odometry& moved;  // as far as it is believed
};

// After odometry and landmarks, before the lines.
void usePinks(const PinksIn& in, const PinkContext& context, PinkState& pinks, PoseState& pose,
              GpsCounts& counts);

}  // namespace kelpie::gps
