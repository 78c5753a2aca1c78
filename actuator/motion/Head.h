// SPDX-License-Identifier: Apache-2.0
// Where the head goes next: towards the HeadRequest at the requested speed, inside the ranges in
// which neck and head do not touch the body.
#pragma once

#include "actuator/ActuatorParams.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Joints.h"

namespace kelpie::actuator {

// The joints of `now` with the head moved on by at most one tick of the requested speed.
JointAngles headTarget(const HeadRequest& request, const JointAngles& now,
                       const ActuatorParams& params);

}  // namespace kelpie::actuator
