// SPDX-License-Identifier: Apache-2.0
// What cannot be in one image together.
#pragma once

#include "robot/core/Percepts.h"

namespace kelpie::vision {

// The two goals are at opposite ends: of two in one image the one that covers less is somebody's
// clothes (facts-2005 4.5 check 10). It is dropped and counted.
void keepOneGoal(Percepts& percepts);

}  // namespace kelpie::vision
