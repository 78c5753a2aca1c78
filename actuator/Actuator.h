// SPDX-License-Identifier: Apache-2.0
// actuator: the Command becomes joint targets every 8 ms: start ramp, stance, trot, head, special
// motions, limits; and the odometry of what was walked.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/ActuatorState.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// Four ticks at a time: the joint targets for the four ticks after the sensed ones.
MotionOutput step(const MotionInput& in, const ActuatorParams& params, ActuatorState& state);

}  // namespace kelpie::actuator
