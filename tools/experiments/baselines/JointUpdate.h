// SPDX-License-Identifier: Apache-2.0
// A frame's landmarks and lines in one update of each mode (thesis 2004 section 5.1, future work
// there): all is linearised at the predicted pose and added up as information, and one copy that
// nothing corrected stays for the case that any of it was false. The alternative, one landmark
// after the other and then the lines, keeps a copy for each and is what the robot uses.
// Fails as a whole where one of many landmarks is false; then the copy has to live.
#pragma once

#include "gps/Gaussian.h"
#include "gps/PoseSteps.h"
#include "gps/lines/LineUpdate.h"
#include "gps/lines/PaintedField.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

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
