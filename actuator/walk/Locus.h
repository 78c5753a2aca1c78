// SPDX-License-Identifier: Apache-2.0
// The path of a foot through one step, without size: a stroke on the ground from +1 (ahead) to -1,
// then a swing back through the air. `rectangular`: up, across, down (the NormalWalk of 2005);
// `elliptical`: one ellipse, whose lower half presses into the ground (2004); `halfEllipse`: a
// straight stroke and half an ellipse (2005's Skelliptical; facts-2005 section 6.3).
#pragma once

#include "actuator/walk/WalkSet.h"

namespace kelpie::actuator {

struct LocusPoint {
  double along = 0.0;   // in half strokes
  double height = 0.0;  // in lifts
};

// `phase`: of this foot, 0 where the stroke begins, 1 where it begins again; the stroke lasts
// `duty`. `lead`: how fast the foot moves as it leaves the ground and comes down, beside the ground
// below it (0 to 1); so it does not drag while it is low.
LocusPoint locusPoint(LocusShape shape, double phase, double duty, double lead);

}  // namespace kelpie::actuator
