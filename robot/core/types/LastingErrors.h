// SPDX-License-Identifier: Apache-2.0
// What the localiser believes to be otherwise than it was told, for seconds or for the whole match:
// landmarks that do not stand where the map has them, and odometry that tells steps of another
// length. Cautious: a beacon 14 cm off its place is told as 8 to 10 cm off, and as on it some
// seconds after it was last seen.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/ObjectPercepts.h"

namespace kelpie {

// A landmark that seems to stand where the map does not have it, and is used there.
struct MovedLandmark {
  LandmarkKind kind = LandmarkKind::goalBlue;
  Point2<Field> offset;  // from its place on the map

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("kind", &MovedLandmark::kind, "", 0, 5),
                     field("offset", &MovedLandmark::offset));
  }
};
using MovedLandmarks = FixedVector<MovedLandmark, kLandmarkKindCount>;

// By what share steps are longer than the odometry tells, and how much more the robot turns to the
// left while it walks; each with its standard deviation.
struct OdometryErrorEstimate {
  bool present = false;  // otherwise nothing is kept of it: steps count as they are told
  double scaleAhead = 0.0;
  double scaleAheadSd = 0.0;
  double scaleAside = 0.0;
  double scaleAsideSd = 0.0;
  double turnRate = 0.0;    // rad/s
  double turnRateSd = 0.0;  // rad/s

  template <int = 0>
  static constexpr auto fields() {
    using E = OdometryErrorEstimate;
    return fieldList(field("present", &E::present), field("scaleAhead", &E::scaleAhead, "", -1, 1),
                     field("scaleAheadSd", &E::scaleAheadSd, "", 0, 10),
                     field("scaleAside", &E::scaleAside, "", -1, 1),
                     field("scaleAsideSd", &E::scaleAsideSd, "", 0, 10),
                     field("turnRate", &E::turnRate, "rad/s", -3, 3),
                     field("turnRateSd", &E::turnRateSd, "rad/s", 0, 10));
  }
};

}  // namespace kelpie
