// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for dark things on the carpet (facts-2005 section 4.2, thesis 2006 section
// 6.4.4).
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct ObstacleParams {
  double maxOfCarpet = 0.31;  // of the carpet's brightness over black: a dark pixel; Y 35 on Y 77
  bool greyCounts = true;     // so does an ERS-7's leg, which is not dark: see README.md
  double maxPerLine = 5;      // pixels that count on one scan line
  double maxGreenAbove = 10;  // px of the next 20 upwards; more: a shadow
  double maxBallAbove = 5;    // px of orange in them; more: the ball's shadow
  double maxDistance = 200;   // cm
  double aheadSide = 25;      // cm, half the width of the box ahead
  double aheadFar = 100;      // cm, its length

  template <int = 0>
  static constexpr auto fields() {
    using P = ObstacleParams;
    return fieldList(field("maxOfCarpet", &P::maxOfCarpet, "", 0, 1),
                     field("greyCounts", &P::greyCounts),
                     field("maxPerLine", &P::maxPerLine, "", 1, 80),
                     field("maxGreenAbove", &P::maxGreenAbove, "px", 0, 20),
                     field("maxBallAbove", &P::maxBallAbove, "px", 0, 20),
                     field("maxDistance", &P::maxDistance, "cm", 10, 500),
                     field("aheadSide", &P::aheadSide, "cm", 1, 200),
                     field("aheadFar", &P::aheadFar, "cm", 1, 500));
  }
};

}  // namespace kelpie::vision
