// SPDX-License-Identifier: Apache-2.0
// A small player in C++ for a robot without Python: gets up, looks at the ball and walks to it,
// else turns on the spot and looks for it. It knows no field, no goal and no other robot, and it
// never kicks: the ball is pushed where it happens to go. A light on its back tells it from the
// player in Python (body/Lights.h).
#pragma once

#include "behaviour/BehaviourIn.h"
#include "robot/core/types/Command.h"

namespace kelpie::object {

struct SimpleState {
  bool askedToGetUp = false;  // in the last frame: between two motions one frame asks for none
  bool searchesLeft = true;   // the side where the ball was last
};

Command step(const behaviour::BehaviourIn& in, SimpleState& state);

}  // namespace kelpie::object
