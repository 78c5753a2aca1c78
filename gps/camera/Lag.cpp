// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Lag.h"

#include <cmath>

#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kKnownSd = 1e-4;  // s, where it is not estimated
constexpr double kMinSd = 1e-3;    // s: joints and images are ticks apart

}  // namespace

ImageLag startingLag(const LagParams& params) {
  return {0.0, maths::square(params.use ? params.initialSd : kKnownSd)};
}

double panRate(const FrameInput& input) {
  const Angle lean = input.sensors.joints[Joint::neckTilt] - input.stance.bodyTilt;
  return input.headRate.headPan * lean.cos();
}

void updateLag(const FrameInput& input, const PoseMode& mode, const Measurement& seen,
               const LagParams& params, ImageLag& lag) {
  const double rate = panRate(input);
  if (!params.use || !seen.useHeading || !(std::fabs(rate) >= params.minPanRate)) return;
  if (mode.covariance[8] > maths::square(params.maxHeadingSd.rad())) return;
  const Expectation e = expected(mode.pose, seen.landmark);
  const double known = rate * (lag.seconds - input.imageLag.seconds);
  const double innovation = (seen.heading - e.heading).rad() - known;
  const double variance = rate * rate * lag.variance + mode.covariance[8] + seen.headingVariance;
  if (!(innovation * innovation <= maths::square(params.gate) * variance)) return;
  const double gain = rate * lag.variance / variance;
  lag.seconds = maths::clamp(lag.seconds + gain * innovation, 0.0, params.max);
  lag.variance = std::fmax(lag.variance * (1.0 - gain * rate), maths::square(kMinSd));
}

}  // namespace kelpie::gps
