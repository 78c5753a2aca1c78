// SPDX-License-Identifier: Apache-2.0
// How much longer the focal length is than the body's parameters say. With one that is 4 % too
// short, a landmark at the image's left border is seen 1 deg too far left, and every landmark 4 %
// too near. A scalar Kalman filter beside the pose; vision reads the next image with it. Wrong
// where the pose is, but its errors have one sign on both sides of the image and different signs
// for landmarks ahead and behind.
#pragma once

#include "gps/GpsIn.h"
#include "gps/camera/FocalParams.h"
#include "gps/pose/Landmarks.h"

namespace kelpie::gps {

// Nothing is known but how much lenses differ.
FocalScale startingFocal(const FocalParams& params);

// By bearing and distance of a landmark as the mode expects them.
void updateFocal(const GpsIn& in, const PoseMode& mode, const Measurement& seen,
                 const FocalParams& params, FocalScale& focal);

}  // namespace kelpie::gps
