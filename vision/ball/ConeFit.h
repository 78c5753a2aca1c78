// SPDX-License-Identifier: Apache-2.0
// The outline of a sphere is a circular cone of rays: every edge ray u fulfils n . u = 1 with
// n = axis / cos(half angle), which is linear in n. Exact anywhere in the image, where a circle in
// pixels is an ellipse. Edge points that lie off the cone are dropped and the rest fitted again.
#pragma once

#include "robot/core/ScratchVector.h"
#include "robot/core/types/CameraModel.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::vision {

constexpr std::size_t kMaxEdgePoints = 24;
using EdgePoints = ScratchVector<PixelPoint, kMaxEdgePoints>;

struct Cone {
  bool valid = false;
  Point3<Camera> axis;   // unit vector
  double sinHalf = 0.0;  // of the half angle: radius / distance of the centre
  double rms = 0.0;      // px, of the kept points
  std::size_t kept = 0;
  PixelPoint centre;    // where the axis meets the image
  double radius = 0.0;  // px, as if seen in the middle of the image
};

Cone fitCone(const EdgePoints& points, const Lens& lens);

}  // namespace kelpie::vision
