// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/Falls.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

constexpr double kRange = 1962.0;  // cm/s2, two g: what the sensor can tell

void filter(const std::array<double, 3>& acceleration, double ticks, std::array<double, 3>& up) {
  const double share = 1.0 / std::max(ticks, 1.0);
  for (std::size_t k = 0; k < up.size(); ++k) {
    if (!std::isfinite(acceleration[k])) continue;
    up[k] += share * (maths::clamp(acceleration[k], -kRange, kRange) - up[k]);
  }
}

// The side that is down the most. A robot that sits on its tail is on the way to its back.
FallSide lowestSide(const std::array<double, 3>& up) {
  const auto [forward, left, upward] = up;
  const double back = std::max(-upward, forward);
  const double side = std::fabs(left);
  if (-forward > std::max(back, side)) return FallSide::front;
  if (back > side) return FallSide::back;
  return left < 0.0 ? FallSide::left : FallSide::right;
}

// Far less than the weight: the robot is in the air, or the sensor tells nothing.
bool weightless(const std::array<double, 3>& up) {
  constexpr double kMin = 490.0;  // cm/s2
  return maths::square(up[0]) + maths::square(up[1]) + maths::square(up[2]) < maths::square(kMin);
}

FallSide seenNow(const FallParams& params, const FallState& state) {
  if (weightless(state.up)) return state.fallen;
  const bool lies = state.fallen != FallSide::none;
  const double bound = lies ? params.uprightAbove : params.fallenBelow;
  return state.up[2] > bound ? FallSide::none : lowestSide(state.up);
}

}  // namespace

void stepFalls(const MotionInput& in, const FallParams& params, FallState& state) {
  for (const SensorFrame& tick : in.sensors)
    filter(tick.acceleration, params.filterTicks, state.up);
  const FallSide now = seenNow(params, state);
  state.messages = now == state.seen ? state.messages + 1 : 1;
  state.seen = now;
  if (state.messages >= params.messages) state.fallen = now;
}

}  // namespace kelpie::actuator
