// SPDX-License-Identifier: Apache-2.0
// From the moment of the exposure to that of the stamp. Where images lag, poses and percepts are
// those of `imageLag` before FrameInput::time; a robot that turns at 115 deg/s has turned on by 4
// deg since. Takes the rate of the last frame for that time. Covariances stay as they were.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

// What was walked since the exposure.
Odometry sinceExposure(const FrameInput& input);

// The robot, and what is relative to it, after such a step. What lies on the field stays.
void bringForward(const Odometry& step, WorldModel& world);

}  // namespace kelpie::gps
