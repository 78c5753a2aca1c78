// SPDX-License-Identifier: Apache-2.0
// What was walked in each tick: from the commanded speed of the feet some ticks ago, as the body
// does it late, and from what the joints of the standing feet say now, by the curves and shares of
// the walk; and how sure that is. A robot that stands does not move, whatever carries it.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/Feet.h"
#include "actuator/FootMotion.h"
#include "robot/core/Motion.h"

namespace kelpie::actuator {

constexpr std::size_t kMaxDelay = 24;  // ticks of odometry kept back

// One commanded tick.
struct CommandedTick {
  Velocity real;         // that the commands alone make likely
  Velocity joints;       // share of the feet's motion in each direction; 0 standing and in motions
  bool special = false;  // of a special motion
};

struct OdometryState {
  std::array<CommandedTick, kMaxDelay + kTicksPerMessage> ticks{};  // a ring of the last
  std::uint32_t count = 0;
  FootMotionState feet;
};

void record(const CommandedTick& tick, OdometryState& state);

// Of the last four ticks.
Odometry odometry(const MotionInput& in, const OdometryParams& params, OdometryState& state);

}  // namespace kelpie::actuator
