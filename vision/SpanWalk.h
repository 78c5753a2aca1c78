// SPDX-License-Identifier: Apache-2.0
// Walks through a coloured patch, pixel by pixel at full resolution, to its edge, and places the
// edge between two pixels where the colour is half-way between inside and outside.
#pragma once

#include "robot/core/Geometry.h"
#include "robot/core/Percepts.h"
#include "vision/Sampler.h"

namespace kelpie::vision {

struct SpanWalk {
  PixelPoint from;
  double dx = 0.0;  // unit vector in the image
  double dy = 0.0;
  ColourClass colour = ColourClass::none;
  int holes = 1;  // pixels of another class to step over
};

struct EdgeHit {
  PixelPoint point;
  bool cut = false;     // the image ends before the patch does
  double length = 0.0;  // px from the start
};

EdgeHit walkToEdge(const Sampler& sampler, const SpanWalk& walk);

// Direction in the image in which the elevation rises fastest at the middle of the image.
struct ImageUp {
  double dx = 0.0;
  double dy = -1.0;
};
ImageUp imageUp(const CameraPose& camera);

}  // namespace kelpie::vision
