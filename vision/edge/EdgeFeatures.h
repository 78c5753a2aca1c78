// SPDX-License-Identifier: Apache-2.0
// Where the green ends: on each scan line the highest lasting change to green, at full resolution.
// Thesis 2006 section 3.2.1 walks up and takes the first change; a line or a robot's feet may be
// that, so the walk here is downwards. Fails where something green stands beyond the carpet.
#pragma once

#include "robot/core/ScratchVector.h"
#include "vision/edge/HorizonScan.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

struct EdgeFeature {
  PixelPoint at;
  // The carpet goes on beyond: the image ends there, or something that stands on the carpet hides
  // it. The edge is here or higher.
  bool open = false;
  double weight = 1.0;  // less where it may be the foot of a goal, a beacon or a robot
  bool atGoal = false;  // below a goal's colour: back wall and side walls have feet like edges
};
using EdgeFeatures = ScratchVector<EdgeFeature, kMaxScanLines>;

// At most one for each scan line, in their order.
EdgeFeatures edgeFeatures(const Sampler& sampler, const ScanLines& lines,
                          const FieldEdgeParams& params);

}  // namespace kelpie::vision
