// SPDX-License-Identifier: Apache-2.0
// A frame's landmarks and lines in one update of each mode (thesis 2004 section 5.1, future work
// there): all is linearised at the predicted pose and added up as information, and one copy that
// nothing corrected stays for the case that any of it was false. The alternative, one landmark
// after the other and then the lines, keeps a copy for each. Which is better: docs/experiments.md.
// Fails as a whole where one of many landmarks is false; then the copy has to live.
#pragma once

#include "gps/Gaussian.h"
#include "gps/lines/LineUpdate.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// What several observations say of a mode's error: the information matrix Y, the information vector
// y = Y times the error, and chi squared, the sum of squared innovations over their variances.
struct InformationSum {
  Matrix3 matrix = Matrix3::Zero();
  Vector3 vector = Vector3::Zero();
  double chiSquared = 0.0;
  bool degenerate = false;  // the mode stands on a landmark

  // Linearised at a pose near the mode's; at its own, this is the extended Kalman filter.
  void add(const PoseMode& mode, const Measurement& measurement, const Pose2& at);
  void add(const PoseMode& mode, const PoseObservation& observation);
};

// The mode after all of it: P' = (1 + P Y)^-1 P, mean + P' y, weight times S in (0, 1] of the
// stacked innovation (equation 2.9), times 1 / sqrt(det(1 + P Y)) with `weighByDeterminant`.
PoseMode corrected(const PoseMode& mode, const InformationSum& information,
                   bool weighByDeterminant);

using Measurements = FixedVector<Measurement, 8>;

// All that corrects the pose in a frame; either may be empty.
struct Sightings {
  Measurements landmarks;
  SeenLines lines;
};

struct JointParams {
  const ModeParams& modes;
  const LineUpdateParams& lines;
};

// Returns whether anything was used; then call mergeAndPrune().
bool updateJointly(const Sightings& seen, const PaintedField& field, const JointParams& params,
                   PoseState& state, GpsCounts& counts);

}  // namespace kelpie::gps
