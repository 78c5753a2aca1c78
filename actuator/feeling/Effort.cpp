// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/Effort.h"

#include <algorithm>
#include <cmath>

namespace kelpie::actuator {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;

double hardest(const SensorFrame& sensors) {
  double max = 0.0;
  for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j) {
    const double duty = std::fabs(sensors.duty[j]);
    if (std::isfinite(duty)) max = std::max(max, duty);
  }
  return std::min(max, 1.0);
}

}  // namespace

void recordEffort(const MotionInput& in, bool walking, EffortState& state) {
  if (!walking) {
    state.ticks = 0;
    return;
  }
  for (const SensorFrame& tick : in.sensors)
    state.duty[state.ticks++ % state.duty.size()] = hardest(tick);
}

double effort(const EffortState& state, const GaitParams& gait) {
  const auto halfStep = static_cast<std::uint32_t>(gait.halfStepTicks);
  if (state.ticks < halfStep) return 0.0;
  const std::uint32_t count = std::min(state.ticks, 2 * halfStep);
  double sum = 0.0;
  for (std::uint32_t back = 1; back <= count; ++back)
    sum += state.duty[(state.ticks - back) % state.duty.size()];
  return sum / count;
}

void stepGain(double current, const GainParams& params, GainState& state) {
  if (!std::isfinite(current)) return;
  state.current += (current - state.current) * std::min(1.0, kMessageSeconds / params.seconds);
  state.low = state.current > (state.low ? params.highBelow : params.lowAbove);
}

}  // namespace kelpie::actuator
