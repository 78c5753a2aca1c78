// SPDX-License-Identifier: Apache-2.0
// Corrects one mode by one landmark measurement, an extended Kalman filter's update, and weighs it
// by how well it predicted the measurement (thesis 2004 equations 2.9 and 2.10, signs as in
// checklist H04 and H05).
#pragma once

#include "gps/pose/Landmarks.h"

namespace kelpie::gps {

struct Expectation {
  double distance = 0.0;
  Angle heading;
  // d(distance, heading) / d(x, y, heading), row by row.
  std::array<double, 6> jacobian{};
};

// Too near to be linearised.
bool tooCloseToLinearise(const Pose2& pose, Point2<Field> landmark);
constexpr double kDegenerateWeight = 1e-20;  // weight factor where nothing can be computed

Expectation expected(const Pose2& pose, Point2<Field> landmark);

// Corrects the mode and multiplies its weight by S in (0, 1]. A mode that stands on the landmark
// cannot be linearised and keeps its mean; its weight falls as for a very bad prediction.
void update(PoseMode& mode, const Measurement& measurement, bool weighByDeterminant);

}  // namespace kelpie::gps
