// SPDX-License-Identifier: Apache-2.0
// A mode with a covariance that has all its terms, and a landmark measured with usual variances.
#pragma once

#include "gps/Gaussian.h"
#include "gps/pose/Landmarks.h"

namespace kelpie::gps {

inline PoseMode modeAt(double x, double y, double heading) {
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose = {{x, y}, Angle::rad(heading)};
  mode.covariance = {120, 15, 0.4, 15, 80, -0.3, 0.4, -0.3, 0.05};
  return mode;
}

inline Measurement seenAt(Point2<Field> landmark, double distance, double heading) {
  return {landmark, true, true, distance, Angle::rad(heading), 400.0, 0.004};
}

}  // namespace kelpie::gps
