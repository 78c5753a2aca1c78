// SPDX-License-Identifier: Apache-2.0
// How much older the images are than their stamps; less than nothing where the joints are older
// than theirs. While the head pans, a landmark is then seen beside where it stands by the pan rate
// times the error of the lag: 5 deg at 3 rad/s and one frame. Sightings of one landmark at
// different rates tell it, wherever the robot believes to be: a pose that such sightings have made
// is as wrong as the lag and would hide it. A scalar Kalman filter beside the pose; the agent takes
// the head's joints that much earlier in the next frame. Says nothing while the head is still;
// wrong where the robot turns otherwise than its odometry tells, but that has one sign whichever
// way the head turns.
#pragma once

#include "gps/GpsIn.h"
#include "gps/camera/LagParams.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// What was calibrated; else nothing is known but how much cameras differ.
ImageLag startingLag(const LagParams& params);

// How fast the head turns about the vertical, rad/s.
double panRate(const FrameInput& input);

// How far beside its place all in the image may be for what is not known of the lag, rad2. A
// heading that may be half a turn off says nothing, whatever rate the head claims to have.
double lateVariance(const FrameInput& input);

// The earlier sightings, after a step. They are of maxPairSeconds at most.
void moveLagReferences(const Odometry& step, double elapsed, LagReferences& references);

// What a sighting of a landmark is compared in.
struct LagView {
  const FrameInput& input;
  double late = 0.0;          // rad2, what its heading's variance has of the lag's
  double turnVariance = 0.0;  // rad2/s2, of the rate at which the robot turns
};

// By the bearing of a landmark that was seen a moment before.
void updateLag(const LagView& view, const Measurement& seen, const LagParams& params,
               LagReferences& references, ImageLag& lag);

}  // namespace kelpie::gps
