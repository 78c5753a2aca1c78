// SPDX-License-Identifier: Apache-2.0
// RANSAC with the truncated score of MSAC: straight edges of a convex carpet through features of
// which many are wrong, each line through two sampled points, at most ten rounds for an edge and
// ten more where carpet is seen beyond the first edge. Thesis 2006 section 3.2.2 (eight points,
// correlation as fitness) fails on level or half-covered edges (checklist E4). Hence points that
// lie in line with their neighbours are drawn first; the fitness is the number of inliers, each
// weighted by its closeness, less a fine for carpet seen beyond; a promising line is refitted to
// its inliers at once. A further edge is kept if it makes the whole convex outline fit better and
// is no parallel on the ground. A bend in a line that runs near both arms of a flat corner is tried
// at every feature. Fails where more than about half of the features lie on the foot of one
// obstacle or on something green beyond the carpet.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/edge/EdgeOutline.h"

namespace kelpie::vision {

// Strongest first.
EdgeLines fitEdgeLines(const EdgeFeatures& features, const HorizonFrame& frame,
                       const FieldEdgeParams& params, VisionCounts& counts);

}  // namespace kelpie::vision
