// SPDX-License-Identifier: Apache-2.0
// The three head joints that point the camera's axis in a direction or at a point, the stance
// included. Neck and nod share what is to be looked down: the neck takes more, but stays so high
// that the chin does not touch a ball at the feet. Exact within the joints' ranges; beyond them as
// near as they go. Lengths of facts-2005 section 2.2.
#pragma once

#include "robot/core/types/Command.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// A request for joints, whatever `request` aims at. What is not finite stays not finite.
HeadRequest asJoints(const HeadRequest& request, const Stance& stance);

}  // namespace kelpie::actuator
