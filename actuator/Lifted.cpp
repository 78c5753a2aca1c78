// SPDX-License-Identifier: Apache-2.0
#include "actuator/Lifted.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;

bool pressed(const SensorFrame& tick) {
  return std::any_of(tick.paw.begin(), tick.paw.end(), [](bool paw) { return paw; });
}

bool anyPressed(const MotionInput& in) {
  return std::any_of(in.sensors.begin(), in.sensors.end(), pressed);
}

// Mean of the message, in which a quarter of the noise's variance is left.
std::array<double, 3> meanOf(const MotionInput& in) {
  std::array<double, 3> mean{};
  for (const SensorFrame& tick : in.sensors)
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] +=
          std::isfinite(tick.acceleration[k]) ? tick.acceleration[k] / kTicksPerMessage : 0.0;
  return mean;
}

// How far it is from what it was lately.
double movement(const MotionInput& in, const LiftParams& params, LiftState& state) {
  const std::array<double, 3> now = meanOf(in);
  double squares = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double change = now[k] - state.resting[k];
    squares += maths::square(change);
    state.resting[k] += kMessageSeconds / params.restSeconds * change;
  }
  return std::sqrt(squares);
}

}  // namespace

void stepLifted(const MotionInput& in, bool stands, const LiftParams& params, LiftState& state) {
  const bool paw = anyPressed(in);
  const bool moves = movement(in, params, state) > params.stillBelow;
  state.everPressed = state.everPressed || paw;
  state.free = paw || !stands ? 0.0 : state.free + kMessageSeconds;
  state.still = moves ? 0.0 : state.still + kMessageSeconds;
  if (!state.lifted) {
    state.lifted = state.everPressed && state.free >= params.freeSeconds;
    state.still = 0.0;
    return;
  }
  const double needed = paw ? params.stillSeconds : params.stillWithoutPaw;
  if (state.still < needed) return;
  state.lifted = false;
  state.free = 0.0;
}

}  // namespace kelpie::actuator
