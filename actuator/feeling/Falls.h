// SPDX-License-Identifier: Apache-2.0
// Whether the robot lies, and on which side, from the accelerometer alone: its low pass tells where
// up is. Confirmed over some messages; nobody has got up before the body is well upright again.
// Limits: a robot that lies on its belly with its legs spread looks upright; in the air, and while
// it is thrown about for longer than the low pass, nothing is known.
#pragma once

#include "actuator/feeling/FeelingParams.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

struct FallState {
  std::array<double, 3> up{0.0, 0.0, 981.0};  // cm/s2, low passed
  FallSide fallen = FallSide::none;
  FallSide seen = FallSide::none;  // in the last message
  std::uint32_t messages = 0;      // that saw it in a row
};

// One message. A sample that is not finite is left out, one out of the sensor's range clipped.
void stepFalls(const MotionInput& in, const FallParams& params, FallState& state);

}  // namespace kelpie::actuator
