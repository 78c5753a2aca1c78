// SPDX-License-Identifier: Apache-2.0
// Whether somebody has lifted the robot off the ground. A robot that stands or walks presses a paw
// at least every 0.1 s (the longest without one in a match of the physical world), so that all four
// free for longer are in the air, unless the accelerometer tells that it falls. It stands again
// when a paw is pressed and the accelerometer has been still for a while; without a paw, as on its
// belly with slack legs, after a longer while.
// Limits: a robot that lies, kicks, or has fallen is not seen to be lifted, since its paws are free
// in any case; nor is one whose paw switches have never closed.
#pragma once

#include <array>

#include "actuator/FeelingParams.h"
#include "robot/core/Motion.h"

namespace kelpie::actuator {

struct LiftState {
  bool lifted = false;
  bool everPressed = false;                        // the switches close at all
  double free = 0.0;                               // s, of all paws
  double still = 0.0;                              // s
  std::array<double, 3> resting{0.0, 0.0, 981.0};  // cm/s2, low passed
};

// One message. `stands`: upright, on legs that stand or walk.
void stepLifted(const MotionInput& in, bool stands, const LiftParams& params, LiftState& state);

}  // namespace kelpie::actuator
