// SPDX-License-Identifier: Apache-2.0
// How much older the images are than their stamps. While the head pans, a landmark is then seen
// beside where it stands by the pan rate times the error of the lag: 5 deg at 3 rad/s and one
// frame. A scalar Kalman filter beside the pose; the agent takes the head's joints that much
// earlier in the next frame. Says nothing while the head is still; wrong where the pose is, but the
// errors of a pose have one sign whichever way the head turns.
#pragma once

#include "gps/GpsIn.h"
#include "gps/camera/LagParams.h"
#include "gps/pose/Landmarks.h"

namespace kelpie::gps {

// Nothing is known but how much cameras differ.
ImageLag startingLag(const LagParams& params);

// How fast the head turns about the vertical, rad/s.
double panRate(const FrameInput& input);

// By the bearing of a landmark as the mode expects it.
void updateLag(const FrameInput& input, const PoseMode& mode, const Measurement& seen,
               const LagParams& params, ImageLag& lag);

}  // namespace kelpie::gps
