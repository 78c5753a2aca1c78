// SPDX-License-Identifier: Apache-2.0
// Corrects a mode by what was observed, an extended Kalman filter's update in information form, and
// weighs it by how well it predicted the observations (thesis 2004 equations 2.9 and 2.10, signs as
// in checklist H04 and H05). Landmarks, lines and pinks all pass through it: one observation or the
// sum of several, of any rank. Fails where a mode stands on a landmark: it keeps its mean then, and
// its weight falls as for a very bad prediction.
#pragma once

#include "gps/Gaussian.h"
#include "gps/pose/Landmarks.h"

namespace kelpie::gps {

// Of the pose itself. Singular where nothing is known of it.
struct PoseObservation {
  Pose2 pose;
  Matrix3 information;
};

struct Expectation {
  double distance = 0.0;
  Angle heading;
  // d(distance, heading) / d(x, y, heading), row by row.
  std::array<double, 6> jacobian{};
};
Expectation expected(const Pose2& pose, Point2<Field> landmark);

struct Innovation {
  double value = 0.0;
  double variance = 0.0;  // the mode's and the measurement's
};
Innovation bearingInnovation(const PoseMode& mode, const Measurement& seen);  // rad

// What several observations say of a mode's error: the information matrix Y, the information vector
// y = Y times the error, and chi squared, the sum of squared innovations over their variances.
struct InformationSum {
  Matrix3 matrix = Matrix3::Zero();
  Vector3 vector = Vector3::Zero();
  double chiSquared = 0.0;
  bool degenerate = false;  // too close to a landmark to linearise

  // Linearised at a pose near the mode's; at its own, this is the extended Kalman filter.
  void add(const PoseMode& mode, const Measurement& measurement, const Pose2& at);
  void add(const PoseMode& mode, const PoseObservation& observation);
};

// The mode after all of it: P' = (1 + P Y)^-1 P, mean + P' y, weight times S in (0, 1] of the
// stacked innovation (thesis 2004 equation 2.9), without the determinant (checklist B-2.1.3.2).
PoseMode corrected(const PoseMode& mode, const InformationSum& information);

// The same by one observation.
PoseMode corrected(const PoseMode& mode, const Measurement& measurement);
// The same by a landmark, weighed with the determinant, so that a vague mode pays for all that it
// would have explained as well. Modes that would see a goal at a grazing angle, and take its
// heading alone, pay what the whole sighting costs: weighed by what they take they outgrew the true
// one in every frame.
PoseMode correctedByLandmark(const PoseMode& mode, const Measurement& seen);
PoseMode corrected(const PoseMode& mode, const PoseObservation& observation);

}  // namespace kelpie::gps
