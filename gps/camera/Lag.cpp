// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Lag.h"

#include <cmath>

#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

constexpr double kKnownSd = 1e-4;  // s, where it is not estimated
constexpr double kMinSd = 1e-3;    // s: joints and images are ticks apart

// An innovation, how much of it a second of lag explains, and its variance without the lag's.
struct LagSighting {
  double innovation = 0.0;
  double slope = 0.0;
  double variance = 0.0;
};

void correct(const LagSighting& z, const LagParams& params, ImageLag& lag) {
  const double variance = z.slope * z.slope * lag.variance + z.variance;
  if (!(z.innovation * z.innovation <= maths::square(params.gate) * variance)) return;
  const double gain = z.slope * lag.variance / variance;
  lag.seconds = maths::clamp(lag.seconds + gain * z.innovation, params.min, params.max);
  lag.variance = std::fmax(lag.variance * (1.0 - gain * z.slope), maths::square(kMinSd));
}

}  // namespace

ImageLag startingLag(const LagParams& params) {
  return {0.0, maths::square(params.use ? params.initialSd : kKnownSd)};
}

double panRate(const FrameInput& input) {
  const Angle lean = input.sensors.joints[Joint::neckTilt] - input.stance.bodyTilt;
  return input.headRate.headPan * lean.cos();
}

double lateVariance(const FrameInput& input) {
  const double late = maths::square(panRate(input)) * input.imageLag.variance;
  return std::fmin(late, maths::square(maths::kPi));
}

void moveLagReferences(const Odometry& step, double elapsed, LagReferences& references) {
  for (LagReference& reference : references) {
    if (!reference.present) continue;
    reference.age += elapsed;
    reference.place = robotFromField(moved({}, step), fieldFromRobot({}, reference.place));
  }
}

void updateLag(const LagView& view, const Measurement& seen, const LagParams& params,
               LagReferences& references, ImageLag& lag) {
  if (!params.use || !seen.useHeading) return;
  LagReference& before = references[static_cast<std::size_t>(seen.kind)];
  const double rate = panRate(view.input);
  const double variance = seen.headingVariance - view.late;
  const bool young = before.present && before.age <= params.maxPairSeconds;
  if (young && std::fabs(rate - before.rate) < params.minRateChange) return;
  if (young) {
    const double slope = rate - before.rate;
    const double known = rate * (lag.seconds - view.input.imageLag.seconds) -
                         before.rate * (lag.seconds - before.usedLag);
    const double turned = view.turnVariance * maths::square(before.age);
    const double beside = (seen.heading - bearing(before.place)).rad();
    correct({beside - known, slope, variance + before.variance + turned}, params, lag);
  }
  before = {true,     0.0,  robotPolar(seen.distance, seen.heading),
            variance, rate, view.input.imageLag.seconds};
}

}  // namespace kelpie::gps
