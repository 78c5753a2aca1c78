// SPDX-License-Identifier: Apache-2.0
// Whether a ball lies between chin, chest and forelegs, felt in a window of ticks while the head is
// commanded into the pose that holds one: a touch of the chin's switch, a neck that does not sag,
// or a chest sensor whose reading folds back because something is closer than it can tell.
// Says no until the window is full of that pose; with no ball a stiffer neck would fool the sag.
#pragma once

#include <array>

#include "actuator/feeling/FeelingParams.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

struct HeldBallTick {
  double sag = 0.0;  // deg that the neck is below its target
  double chest = 0.0;
  bool chin = false;
};

struct HeldBallState {
  std::array<HeldBallTick, 60> felt{};  // a ring
  std::uint32_t ticks = 0;              // in the pose without a break
};

// One message. `commanded`: where the joints were commanded to be in the last one.
bool stepHeldBall(const MotionInput& in, const JointAngles& commanded, const HeldBallParams& params,
                  HeldBallState& state);

}  // namespace kelpie::actuator
