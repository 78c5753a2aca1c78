// SPDX-License-Identifier: Apache-2.0
// Joints of a robot whose joints nobody recorded: it stands on straight legs below its shoulders
// and steps, diagonal legs together, as far as it goes. Made up, to look at only.
#pragma once

#include "robot/core/types/Joints.h"
#include "robot/core/types/Motion.h"

namespace kelpie::broadcast {

// `way`: what it has walked so far, in cm, a turn as the way of a leg; `pace`: how fast, in cm/s.
JointAngles walkingJoints(const Stance& stance, double way, double pace);

}  // namespace kelpie::broadcast
