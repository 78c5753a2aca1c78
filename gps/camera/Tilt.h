// SPDX-License-Identifier: Apache-2.0
// How much the body leans more than its joints say, as two slow states of every mode beside its
// pose: tilt and roll (robot/core/types/CameraModel.h). Landmarks and the ball tell them by how
// much higher they are seen than they stand (ElevationError), lines by lying better on the painted
// ones (LineUpdate), and the accelerometer a little. Thesis 2004 has no such state; its robots'
// tilts were wrong by up to 3 deg (facts-2005 section 2.1). Wrong after the body's stance changes
// until the next sighting, and while a walking body sways by more than `oscillationSd`.
#pragma once

#include "gps/GpsIn.h"
#include "gps/camera/TiltParams.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// Nothing is known but how much robots differ.
CameraTilt startingTilt(const TiltParams& params);

// Time passes, the body shaking by as much (Shake.h).
void driftTilt(double elapsed, double shaking, const TiltParams& params, Modes& modes);

// How much more the camera looks up in a direction (a unit vector on the ground, robot frame) than
// the image was read with: as much as something is seen too low there.
struct TiltSighting {
  double right = 0.0;
  double forward = 1.0;
  double excess = 0.0;    // rad
  double variance = 0.0;  // rad2
};

using TiltSightings = FixedVector<TiltSighting, 16>;

// What a frame's landmarks, ball and accelerometer say.
TiltSightings elevationSightings(const GpsIn& in, const TiltParams& params);

// A Kalman update of every mode's tilt, roll and, with what they have in common, pose by what lies
// inside the heaviest one's gate; the rest is counted. Weights stay.
void useTiltSightings(const TiltSightings& sightings, const CameraTilt& readWith,
                      const TiltParams& params, Modes& modes, GpsCounts& counts);

}  // namespace kelpie::gps
