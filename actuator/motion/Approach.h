// SPDX-License-Identifier: Apache-2.0
// From wherever the joints are to a pose, in a straight line and gently: at the start, after every
// rest, and on the way down to lie. No joint is asked for more than `startRate`, however far it
// has to go, because a person may have a hand at the robot. All joints arrive together.
#pragma once

#include "actuator/ActuatorParams.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

struct ApproachState {
  bool active = false;
  std::uint32_t ticks = 0;  // that it shall still take, if no joint's way is longer
};

void begin(const ActuatorParams& params, ApproachState& state);

// The next tick's targets on the way from `now` to `pose`; ends when they are the pose.
JointAngles approached(const JointAngles& pose, const JointAngles& now,
                       const ActuatorParams& params, ApproachState& state);

}  // namespace kelpie::actuator
