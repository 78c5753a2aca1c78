// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the map of obstacles. Numbers of facts-2005 section 4.7 where it states
// them, else ours.
#pragma once

#include "robot/core/types/Geometry.h"

namespace kelpie::gps {

struct ObstacleMapParams {
  double forgetRate = 0.606;     // 1/s of own points: keeps 0.98 a frame
  double forgetHeardRate = 2.0;  // 1/s of what a mate said; it says it again six times a second
  double maxCount = 100.0;       // of one cell
  double minReach = 12.0;        // cm; nearer points are of the own body
  double maxReach = 250.0;       // cm; farther points are not mapped
  double maxPositionSd = 50.0;   // cm of the own place; with more nothing is mapped or sent
  Angle maxHeadingSd = Angle::deg(20.0);
  double clearReach = 150.0;  // cm; carpet seen nearer than this empties its cell
  double clearShare = 0.8;    // of a cell's points that carpet seen in it leaves
  double robotCount = 2.0;    // points of a robot seen: its white body gives none
  double tellCount = 5.0;     // a cell with less is not sent to the team

  template <int = 0>
  static constexpr auto fields() {
    using P = ObstacleMapParams;
    return fieldList(field("forgetRate", &P::forgetRate, "1/s", 0, 100),
                     field("forgetHeardRate", &P::forgetHeardRate, "1/s", 0, 100),
                     field("maxCount", &P::maxCount, "", 1, 1e4),
                     field("minReach", &P::minReach, "cm", 0, 100),
                     field("maxReach", &P::maxReach, "cm", 10, 1000),
                     field("maxPositionSd", &P::maxPositionSd, "cm", 1, 1000),
                     field("maxHeadingSd", &P::maxHeadingSd, "rad", 1, 180),
                     field("clearReach", &P::clearReach, "cm", 0, 1000),
                     field("clearShare", &P::clearShare, "", 0.01, 1),
                     field("robotCount", &P::robotCount, "", 0, 100),
                     field("tellCount", &P::tellCount, "", 0, 1e4));
  }
};

}  // namespace kelpie::gps
