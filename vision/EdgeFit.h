// SPDX-License-Identifier: Apache-2.0
// Straight edges of a convex carpet through features of which many are wrong: random sampling of
// two points in at most ten rounds, with three changes to thesis 2006 section 3.2.2 (eight points,
// correlation as fitness), whose success on level or half-covered edges is poor (checklist E4):
// points that lie on a line with their neighbours are drawn first; the fitness is the number of
// inliers, each weighted by its closeness, less a fine for carpet seen beyond; a promising line is
// refitted to its inliers at once. Lines are in normal form, so that upright ones are no exception.
#pragma once

#include "vision/EdgeFeatures.h"

namespace kelpie::vision {

// Points with nx x + ny y = offset; the normal has length 1 and points off the carpet.
struct EdgeLine {
  double nx = 0.0;
  double ny = -1.0;
  double offset = 0.0;
  std::size_t support = 0;  // inliers
  double rms = 0.0;         // px, of the inliers

  double beyond(PixelPoint p) const { return nx * p.x + ny * p.y - offset; }
};
using EdgeLines = FixedVector<EdgeLine, 3>;

// Strongest first. `level` says which side of a line is off the carpet.
EdgeLines fitEdgeLines(const EdgeFeatures& features, const ImageLevel& level,
                       const FieldEdgeParams& params);

}  // namespace kelpie::vision
