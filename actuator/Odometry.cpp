// SPDX-License-Identifier: Apache-2.0
#include "actuator/Odometry.h"

namespace kelpie::actuator {

void record(const Velocity& real, OdometryState& state) {
  state.speed[state.ticks++ % state.speed.size()] = real;
}

Odometry odometry(const OdometryParams& params, const OdometryState& state) {
  Odometry sum;
  for (std::uint32_t i = kTicksPerMessage; i >= 1; --i) {
    const std::uint32_t back = i + params.delayTicks;
    if (state.ticks < back || back > state.speed.size()) continue;
    const Velocity& v = state.speed[(state.ticks - back) % state.speed.size()];
    const double forward = v.forward * kTickSeconds;
    const double left = v.left * kTickSeconds;
    sum.forward += forward * sum.turn.cos() - left * sum.turn.sin();
    sum.left += forward * sum.turn.sin() + left * sum.turn.cos();
    sum.turn = sum.turn + Angle::rad(v.turn * kTickSeconds);
  }
  return sum;
}

}  // namespace kelpie::actuator
