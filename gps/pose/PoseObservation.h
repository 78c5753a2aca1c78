// SPDX-License-Identifier: Apache-2.0
// An observation of the pose itself, and a mode's correction by it.
#pragma once

#include "gps/Gaussian.h"

namespace kelpie::gps {

// Singular where nothing is known of the pose.
struct PoseObservation {
  Pose2 pose;
  Matrix3 information;
};

// Kalman update in information form, valid for singular information: A = (1 + P L)^-1,
// gain = A P L, P' = A P. Multiplies the weight by S in (0, 1] (equation 2.9).
void correct(PoseMode& mode, const PoseObservation& observation);

}  // namespace kelpie::gps
