// SPDX-License-Identifier: Apache-2.0
// Lies down when the robot rests and stands up again afterwards: from wherever the joints are in a
// straight line to the pose, and back to the stance. A motion that was under way is broken off.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/ActuatorState.h"

namespace kelpie::actuator {

void stepLie(Rest rest, const ActuatorParams& params, ActuatorState& state);

// Legs, head and mouth as they lie.
void lieDown(JointAngles& target);

}  // namespace kelpie::actuator
