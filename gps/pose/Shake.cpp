// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Shake.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

constexpr double kUnit = 100.0;  // cm/s2

void follow(double value, double elapsed, double seconds, double& mean) {
  mean += (value - mean) * std::min(1.0, elapsed / seconds);
}

}  // namespace

double excessShake(const FrameInput& input, const ShakeParams& params, ShakeState& state) {
  const double left = input.sensors.acceleration[1];
  if (!params.use || !std::isfinite(left)) return 0.0;
  const double elapsed = elapsedOf(input);
  follow(left, elapsed, params.meanSeconds, state.mean);
  follow(std::fabs(left - state.mean), elapsed, params.shakeSeconds, state.deviation);
  return std::max(0.0, state.deviation - params.free) / kUnit;
}

double shaking(const ShakeState& state) { return state.deviation / kUnit; }

Odometry shortened(const Odometry& odometry, double excess, const ShakeParams& params) {
  if (excess <= 0.0) return odometry;
  const double share = 1.0 / (1.0 + params.slowing * excess);
  return {share * odometry.forward, share * odometry.left, odometry.turn, odometry.variance};
}

StepNoise shaken(const StepNoise& noise, double excess, double elapsed, const ShakeParams& params) {
  if (excess <= 0.0) return noise;
  const double pushed = params.pushed * excess * elapsed;
  return {noise.forward + pushed, noise.left + pushed,
          noise.turn + params.turned * excess * elapsed};
}

}  // namespace kelpie::gps
