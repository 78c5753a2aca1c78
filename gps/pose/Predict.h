// SPDX-License-Identifier: Apache-2.0
// Moves a pose mode with the odometry (thesis 2004 section 2.2.4): the mean along its own heading,
// the covariance through the Jacobian, the noise turned from the robot's frame into the field's.
#pragma once

#include "gps/pose/PoseParams.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

// Variances of one odometry step in the robot's frame.
struct StepNoise {
  double forward = 0.0;  // cm2
  double left = 0.0;     // cm2
  double turn = 0.0;     // rad2
};

// The step that is believed, and its noise.
struct Step {
  Odometry odometry;
  StepNoise noise;
};

// s since the frame before: at least 0, at most 10, and 0 for NaN.
double elapsedOf(const FrameInput& input);

// False for what no walk can do in one frame (30 cm, half a turn) and for what is not finite.
bool plausible(const Odometry& odometry);

StepNoise scaledBy(double scale, const StepNoise& noise);
// Variances that the odometry tells, else those of `noise`.
StepNoise stepNoise(const Odometry& odometry, double elapsed, const MotionNoise& noise);

Pose2 moved(const Pose2& pose, const Odometry& odometry);

// d moved(pose) / d pose, row by row.
std::array<double, 9> movedJacobian(const Pose2& pose, const Odometry& odometry);

void predict(PoseMode& mode, const Odometry& odometry, const StepNoise& noise);

}  // namespace kelpie::gps
