// SPDX-License-Identifier: Apache-2.0
// What was walked in each tick, told some ticks later, when the body has really done it.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/Feet.h"
#include "robot/core/Motion.h"

namespace kelpie::actuator {

constexpr std::size_t kMaxDelay = 24;  // ticks of odometry kept back

struct OdometryState {
  std::array<Velocity, kMaxDelay + kTicksPerMessage> speed{};  // a ring of the last ticks
  std::uint32_t ticks = 0;
};

// One tick at that real speed.
void record(const Velocity& real, OdometryState& state);

// Of the last four ticks, so much before now.
Odometry odometry(const OdometryParams& params, const OdometryState& state);

}  // namespace kelpie::actuator
