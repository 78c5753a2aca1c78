// SPDX-License-Identifier: Apache-2.0
// Points on the field's white lines, at the foot of its white border, and deep in the green: along
// rows and columns ten pixels apart, checked, projected to the ground and weighted by distance
// (thesis 2004 sections 3.1 and 3.2.1). Nothing while the head turns fast.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Scene.h"
#include "vision/line/LinePointParams.h"

namespace kelpie::vision {

double pointWeight(LinePointKind kind, double distance, const LinePointParams& params);
// Pixels of green for a field point so many rows below the horizon: a centimetre ahead fills
// rows^2 / (height * focal length) of them, so that the points lie evenly on the ground. Wrong
// where the head is rolled, as thesis 2004 section 3.1.2 says of its own rule.
double fieldInterval(double rows, const CameraPose& camera, const LinePointParams& params);
// Reads the objects in `out`, whose boxes hold no points; fills its line points and counts.
void findLinePoints(const Scene& scene, const LinePointParams& params, Percepts& out);

}  // namespace kelpie::vision
