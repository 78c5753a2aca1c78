// SPDX-License-Identifier: Apache-2.0
// Points on the field's white lines: along every eighth column the brightness rises and falls again
// between two green places. Projected to the ground; weight 1 near, falling with the square of the
// distance (facts-2005 section 4.6). Nothing while the head turns fast.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/Percepts.h"
#include "vision/Scene.h"
#include "vision/VisionParams.h"

namespace kelpie::vision {

using LinePointBuffer = FixedVector<LinePoint, 256>;

double lineWeight(double distance, const LineParams& params);
void findLinePoints(const Scene& scene, const LineParams& params, LinePointBuffer& points);

}  // namespace kelpie::vision
