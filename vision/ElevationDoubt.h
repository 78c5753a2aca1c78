// SPDX-License-Identifier: Apache-2.0
// What a tilt of the body that is badly known (CameraTilt) leaves open of elevations, feet on the
// ground and rows by the horizon. The limits and curves of vision hold for settled play, in which
// the tilt is known to 0.3 deg; a robot at its start knows it to 1.5 deg. There an error of
// elevation counts for as much less as it is more uncertain, and limits are as much wider. A tilt
// that is known better than in settled play changes nothing: the body sways as much.
#pragma once

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "vision/Scene.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {

// rad, of an elevation in settled play: 0.3 deg of the tilt and as much of joints, stance and sway.
constexpr double kSettledSd = 0.0074;
// By so many standard deviations beyond those of settled play a limit is wider.
constexpr double kSlackSds = 2.0;

// rad2, beyond settled play's.
inline double excessVariance(double variance) {
  constexpr double kSettledVariance = CameraTilt{}.tiltVariance;
  return std::max(0.0, variance - kSettledVariance);
}
inline double excessVariance(const CameraPose& camera, const GroundRay& ray) {
  return excessVariance(body::elevationVariance(camera.tilt, ray.right, ray.forward));
}

struct ElevationDoubt {
  double sd = 0.0;      // rad, beyond settled play's
  double spread = 1.0;  // how many times as uncertain as in settled play an error is

  // rad by which a limit is wider.
  double slack() const { return kSlackSds * sd; }
};

// In a ray's direction, of errors whose standard deviation in settled play is `settledSd` rad.
inline ElevationDoubt elevationDoubt(const CameraPose& camera, const GroundRay& ray,
                                     double settledSd = kSettledSd) {
  const double excess = excessVariance(camera, ray);
  if (excess == 0.0) return {};
  return {std::sqrt(excess), std::sqrt(1.0 + excess / (settledSd * settledSd))};
}

// px by which a limit on rows from the horizon is wider, in the worst direction.
inline double rowSlack(const Scene& scene) {
  const CameraTilt& tilt = scene.body.camera.tilt;
  const double excess = excessVariance(std::max(tilt.tiltVariance, tilt.rollVariance));
  return kSlackSds * focalLength(scene) * std::sqrt(excess);
}

}  // namespace kelpie::vision
