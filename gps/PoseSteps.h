// SPDX-License-Identifier: Apache-2.0
// What becomes of the pose in a frame, in the order of Localiser: odometry, landmarks, pinks, field
// lines. An experiment that puts another method in the place of one of them takes the others from
// here.
#pragma once

#include "gps/GpsIn.h"
#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {

// Time passes: the modes are moved by the odometry as corrected, less where the robot is stuck.
Step moveModes(const GpsIn& in, const GpsParams& params, GpsState& state);

// The camera's tilt, by what is seen too high or too low.
void useElevations(const GpsIn& in, const GpsParams& params, GpsState& state);

// What of the landmarks seen passes the gates; none while landmarks do not count.
using Measurements = FixedVector<Measurement, 8>;
Measurements measurements(const GpsIn& in, const GpsParams& params, GpsCounts& counts);

// How a landmark corrects the modes.
using LandmarkUpdate = void (*)(const Measurement&, const body::FieldDescription&,
                                const ModeParams&, PoseState&, GpsCounts&);

// Starts at the first landmark, corrects by the others, one after the other.
void useLandmarks(const GpsIn& in, const GpsParams& params, GpsState& state,
                  LandmarkUpdate update = updateAll);

// Not after a scrum until the pose is confirmed.
bool linesUsable(const LineUpdateParams& params, const PoseState& pose);

void useLines(const GpsIn& in, const GpsParams& params, GpsState& state);

// In the challenge.
void usePinkPatches(const GpsIn& in, const Odometry& moved, const GpsParams& params,
                    GpsState& state);

// After every change of the modes.
void finishUpdate(const GpsParams& params, GpsState& state);

void noteLandmarks(std::size_t used, const StuckParams& params, GpsState& state);

}  // namespace kelpie::gps
