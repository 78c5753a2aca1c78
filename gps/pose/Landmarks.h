// SPDX-License-Identifier: Apache-2.0
// From a landmark percept to a measurement: which parts pass the gates, and with which variance
// (thesis 2004 section 2.2.2). A percept of which nothing can be used is counted by reason.
#pragma once

#include <cmath>
#include <optional>

#include "gps/pose/PoseParams.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

struct Measurement {
  Point2<Field> landmark;
  bool useDistance = false;
  bool useHeading = false;
  double distance = 0.0;
  Angle heading;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
  // cm of y from the landmark: from nearer a goal looks like a line (thesis 2004 Fig 2.9). It is
  // judged for each mode by itself, so that a wrong best mode cannot veto its own correction.
  double minGoalLineDistance = 0.0;
  double grazingHeadingVariance = 0.0;  // rad2, of the heading seen from there
  LandmarkKind kind = LandmarkKind::goalBlue;
};

inline bool atGrazingAngle(const PoseMode& mode, const Measurement& m) {
  return std::fabs(mode.pose.position.y - m.landmark.y) < m.minGoalLineDistance;
}

// What a mode that would see the goal at a grazing angle takes from it: roughly its heading.
Measurement headingOnly(const Measurement& measurement);

using body::LandmarkMap;

// Whether landmarks count in this frame: not while the robot localises by pinks, for then beacons
// are removed and goals are covered, and what looks like one is false.
bool landmarksCount(const FrameInput& input);

std::optional<Measurement> measurement(const LandmarkPercept& percept, const LandmarkMap& map,
                                       const body::FieldDescription& field,
                                       const LandmarkGates& gates, GpsCounts& counts);

}  // namespace kelpie::gps
