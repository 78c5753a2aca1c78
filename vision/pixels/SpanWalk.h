// SPDX-License-Identifier: Apache-2.0
// Walks through a coloured patch, pixel by pixel at full resolution, to its edge, and places the
// edge between two pixels where the colour is half-way between inside and outside.
#pragma once

#include "robot/core/types/Geometry.h"
#include "vision/pixels/HorizonFrame.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

struct SpanWalk {
  PixelPoint from;
  ImageDirection direction;
  ColourClass colour = ColourClass::none;
  int holes = 1;  // pixels of another class to step over
};

struct EdgeHit {
  PixelPoint point;
  bool cut = false;     // the image ends before the patch does
  double length = 0.0;  // px from the start
};

EdgeHit walkToEdge(const Sampler& sampler, const SpanWalk& walk);

}  // namespace kelpie::vision
