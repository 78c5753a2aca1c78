// SPDX-License-Identifier: Apache-2.0
// A straight border of the carpet in the image, in normal form, so that an upright one is no
// exception, and what a line's geometry gives: through two points, of least squared distance, and
// the angle on the ground between two of them.
#pragma once

#include <cstddef>

#include "robot/core/types/Geometry.h"
#include "vision/pixels/HorizonFrame.h"

namespace kelpie::vision {

// Points with nx x + ny y = offset; the normal has length 1 and points off the carpet.
struct EdgeLine {
  double nx = 0.0;
  double ny = -1.0;
  double offset = 0.0;
  std::size_t support = 0;  // features on it
  std::size_t atGoal = 0;   // of these, those at the foot of a goal
  double rms = 0.0;         // px, of all

  // px beyond the line, off the carpet; negative on it
  double distanceBeyond(PixelPoint p) const { return nx * p.x + ny * p.y - offset; }
};

EdgeLine lineThrough(PixelPoint a, PixelPoint b, const HorizonFrame& frame);

// Sums over weighted points.
struct EdgeMoments {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  void add(PixelPoint p, double weight) {
    const double wx = weight * p.x;
    const double wy = weight * p.y;
    n += weight;
    x += wx;
    y += wy;
    xx += wx * p.x;
    xy += wx * p.y;
    yy += wy * p.y;
  }
  double leastSquares() const;  // px^2, summed, about the best line
};

// The line of least squared distance: regression of y on x, as in 2005 and 2006, fails on steep
// lines (peer-2005 section 1.3).
EdgeLine lineOf(const EdgeMoments& moments, const HorizonFrame& frame);

// Cosine of the angle on the ground between two lines, 0 = square to each other. Each line's
// direction is where the plane through it and the camera meets the horizontal.
double groundCosine(const EdgeLine& a, const EdgeLine& b, const HorizonFrame& frame);

}  // namespace kelpie::vision
