// SPDX-License-Identifier: Apache-2.0
// The Kalman filter of one number that innovations depend on: the image lag by what a turning head
// sees beside, the focal length by what stands beside the axis. An innovation beyond the gate is
// not believed; the variance has a floor, since what is estimated changes slowly.
#pragma once

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::gps {

// An innovation, how much of it one unit of the number explains, and its variance without the
// number's.
struct ScalarSighting {
  double innovation = 0.0;
  double slope = 0.0;
  double variance = 0.0;
};

struct ScalarBounds {
  double min = 0.0;
  double max = 0.0;
  double minSd = 0.0;
  double gate = 0.0;  // standard deviations
};

inline void correct(const ScalarSighting& z, const ScalarBounds& bounds, double& number,
                    double& variance) {
  const double expected = z.slope * z.slope * variance + z.variance;
  if (!(z.innovation * z.innovation <= maths::square(bounds.gate) * expected)) return;
  const double gain = z.slope * variance / expected;
  number = maths::clamp(number + gain * z.innovation, bounds.min, bounds.max);
  variance = std::fmax(variance * (1.0 - gain * z.slope), maths::square(bounds.minSd));
}

}  // namespace kelpie::gps
