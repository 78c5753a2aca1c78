// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Lag.h"

#include <cmath>

#include "gps/camera/ScalarFilter.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

constexpr double kKnownSd = 1e-4;  // s, where it is not estimated
constexpr double kMinSd = 1e-3;    // s: joints and images are ticks apart

// A sighting beside those before.
struct LagSample {
  double rate = 0.0;
  double turned = 0.0;
  double beside = 0.0;  // rad, of the mean's bearing
  double variance = 0.0;
};

void add(const LagSample& sample, const Measurement& seen, LagReference& mean) {
  const double share = 1.0 / ++mean.sightings;
  const Angle where =
      mean.sightings == 1 ? seen.heading : bearing(mean.place) + Angle::rad(share * sample.beside);
  mean.place = robotPolar(seen.distance, where);
  mean.variance += share * (share * sample.variance - (2.0 - share) * mean.variance);
  mean.rate += share * (sample.rate - mean.rate);
  mean.turned += share * (sample.turned - mean.turned);
}

}  // namespace

ImageLag startingLag(const LagParams& params) {
  return {params.initial, maths::square(params.use ? params.initialSd : kKnownSd)};
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
    if (reference.sightings == 0) continue;
    reference.age += elapsed;
    reference.place = robotFromField(moved({}, step), fieldFromRobot({}, reference.place));
  }
}

// A sighting is compared with the mean of those before (Helmert's contrasts): such differences do
// not share their noise, and use all that the sightings tell of the lag.
void updateLag(const LagView& view, const Measurement& seen, const LagParams& params,
               LagReferences& references, ImageLag& lag) {
  if (!params.use || !seen.useHeading) return;
  LagReference& before = references[static_cast<std::size_t>(seen.kind)];
  if (before.age > params.maxPairSeconds) before = {};
  const double rate = panRate(view.input);
  const double turned = rate * view.input.imageLag.seconds;
  const double variance = seen.headingVariance - view.late;
  const double beside = before.sightings > 0 ? (seen.heading - bearing(before.place)).rad() : 0.0;
  const double slope = rate - before.rate;
  if (before.sightings > 0 && std::fabs(slope) >= params.minRateChange) {
    const double known = lag.seconds * slope - (turned - before.turned);
    const double drift = view.turnVariance * maths::square(before.age);
    correct({beside - known, slope, variance + before.variance + drift},
            {params.min, params.max, kMinSd, params.gate}, lag.seconds, lag.variance);
  }
  add({rate, turned, beside, variance}, seen, before);
}

}  // namespace kelpie::gps
