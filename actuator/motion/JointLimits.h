// SPDX-License-Identifier: Apache-2.0
// The one clamp that every joint target passes, whoever asked for it: the soft limits of OPEN-R and
// a greatest change in a tick. An angle that is not finite stays where it was.
#pragma once

#include "robot/core/types/Joints.h"

namespace kelpie::actuator {

struct SlewLimits {
  Angle head;  // a tick; mouth and tail too
  Angle legs;
};

JointAngles limited(const JointAngles& wanted, const JointAngles& last, const SlewLimits& slew);

}  // namespace kelpie::actuator
