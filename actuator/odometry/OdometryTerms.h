// SPDX-License-Identifier: Apache-2.0
// What an even walk likely does: its speeds as sums of terms of the feet's commanded speed and of
// what the body feels, each with its share (WalkOdometry.h). Carpets, servos and weights differ,
// and what they change is felt: load and reach explain half of what walks on varied models differ
// by.
#pragma once

#include "actuator/odometry/Reach.h"
#include "actuator/walk/Feet.h"

namespace kelpie::actuator {

struct Felt {
  double load = 0.0;  // beyond that of a free walk
  Reach reach;
  Velocity change;  // of the feet's recent speed: the body follows late
};

// Each number of AlongTerms or AcrossTerms times this is summed. `joints`: the speed that the
// standing feet's joints say, in the direction that is estimated.
AlongTerms alongFactors(const Velocity& feet, const Felt& felt, double joints);
AcrossTerms leftFactors(const Velocity& feet, const Felt& felt, double joints);
AcrossTerms turnFactors(const Velocity& feet, const Felt& felt, double joints);

// Without what the joints say.
Velocity likelySpeed(const Velocity& feet, const Felt& felt, const WalkOdometry& odometry);

}  // namespace kelpie::actuator
