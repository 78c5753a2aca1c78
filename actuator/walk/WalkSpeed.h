// SPDX-License-Identifier: Apache-2.0
// From what a behaviour wishes to how the feet move: real speeds through the set's calibration, all
// three scaled alike until the set can do them, then approached with bounded acceleration.
#pragma once

#include "actuator/walk/Feet.h"

namespace kelpie::actuator {

// What comes of feet that move at that speed; and how they must move for it. The inverse is exact
// to 1e-6 cm/s within the range where the curves rise.
Velocity realSpeed(const Velocity& feet, const WalkCalibration& calibration);
Velocity feetSpeed(const Velocity& real, const WalkCalibration& calibration);

// The feet's speed for a request. What is not finite counts as 0.
Velocity wantedSpeed(const WalkRequest& request, const WalkSet& set);

// One tick nearer.
Velocity approached(const Velocity& now, const Velocity& wanted, const GaitParams& gait);

inline bool still(const Velocity& v) { return v.forward == 0.0 && v.left == 0.0 && v.turn == 0.0; }

}  // namespace kelpie::actuator
