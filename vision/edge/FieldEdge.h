// SPDX-License-Identifier: Apache-2.0
// The borders of the carpet in the image, one or several (at a corner): scan lines, a feature on
// each, straight lines through them.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/edge/EdgeFit.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

using FieldEdges = FixedVector<FieldEdgePercept, 3>;

FieldEdges findFieldEdges(const Sampler& sampler, const Lattice& lattice,
                          const HorizonScanParams& scan, const FieldEdgeParams& params,
                          VisionCounts& counts);

// Rows at the image's borders. A line that has the carpet above it in the image (the head is rolled
// by more than a right angle) has none and is left out.
FieldEdges edgeRows(const EdgeLines& lines);

}  // namespace kelpie::vision
