// SPDX-License-Identifier: Apache-2.0
// Walking while something holds the robot (thesis 2004 section 2.2.4, checklist U09): legs that
// work harder than free walking needs get less far, and it is unknown how far. Keeps how much of
// the way is thought lost, and whether the field lines are to be left out for a while afterwards
// (thesis 2004 section 5.1). Fails where the feet slip instead of stalling: then nothing is felt.
#pragma once

#include "gps/pose/PoseState.h"
#include "gps/pose/Predict.h"
#include "gps/pose/StuckParams.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// The effort of walking freely so fast, cm/s of the feet.
double freeEffort(double speed, const StuckParams& params);

// q - q0: the effort beyond that of walking freely, 0 to 1; 0 while a special motion runs or no
// walk is requested. A value that no effort can have is refused and counted. Once a frame.
double excessEffort(const FrameInput& input, const StuckParams& params, StuckState& state,
                    GpsCounts& counts);

// Shortened to 1 / (1 + k excess); the same bits when the excess is 0.
Odometry shortened(const Odometry& odometry, double excess, const StuckParams& params);
// Grown by 1 + growth excess, and by pushes and turns of `elapsed` seconds; the same bits when the
// excess is 0.
StepNoise grown(const StepNoise& noise, double excess, double elapsed, const StuckParams& params);

// Once a frame, before the modes move: share lost, and the pause of the lines.
void stepStuck(double excess, double elapsed, const StuckParams& params, StuckState& state);

// A landmark that the modes predicted has corrected them.
void confirm(const StuckParams& params, StuckState& state);

}  // namespace kelpie::gps
