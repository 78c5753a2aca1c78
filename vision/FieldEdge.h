// SPDX-License-Identifier: Apache-2.0
// Where the green ends: per column the highest lasting change to green, then a line through most of
// them by random sampling of two points with the number of inliers as fitness. (The thesis' eight
// points and correlation fail on half-covered and on level edges: checklist E4.)
#pragma once

#include "robot/core/Percepts.h"
#include "vision/Sampler.h"
#include "vision/VisionParams.h"

namespace kelpie::vision {

constexpr std::size_t kEdgeColumns = 50;
using EdgeFeatures = FixedVector<PixelPoint, kEdgeColumns>;

EdgeFeatures fieldEdgeFeatures(const Sampler& sampler, const FieldEdgeParams& params);
FieldEdgePercept fitFieldEdge(const EdgeFeatures& features, const FieldEdgeParams& params);

}  // namespace kelpie::vision
