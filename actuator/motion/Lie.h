// SPDX-License-Identifier: Apache-2.0
// What a rest does to the body. For most causes the robot lies down, and stands up again
// afterwards: from wherever the joints are to the pose, and back to the stance. For some it stays
// as it was found: a joint that is held stays where it was commanded to be, one that is not is
// commanded to where it is sensed, so that it is not pulled when it is held again. A motion that
// was under way is broken off.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/ActuatorState.h"

namespace kelpie::actuator {

void stepRest(const MotionInput& in, const ActuatorParams& params, ActuatorState& state);

// Legs, head and mouth as they lie.
void lieDown(JointAngles& target);

}  // namespace kelpie::actuator
