// SPDX-License-Identifier: Apache-2.0
// Pink patches that are no part of a beacon (thesis 2004 section 4.1.1). Distance from where they
// stand on the carpet, from their size where PinkFinderParams knows it, or from both; without
// either only the heading means something, and the variance says so. Call after findBeacons.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Foot.h"
#include "vision/Scene.h"
#include "vision/pink/PinkFinderParams.h"
#include "vision/pixels/Extent.h"

namespace kelpie::vision {

struct PinkPatch {
  double samples = 0.0;
  PixelBox box;
  PixelPoint centre;
  Extent extent;
  double density = 0.0;  // share of pink in its upright box
  Foot foot;
  double lift = 0.0;          // cm of its lower edge above the ground, where it has a foot
  double carpetBehind = 0.0;  // px of carpet beyond its foot, beside it
};

PinkPatch pinkPatchOf(const HorizonFrame& frame, const Blob& blob);
void measurePink(const Scene& scene, PinkPatch& patch);  // extent, density, foot and behind it

// The checks: true = keep.
bool pinkIsLarge(const PinkPatch& patch, const PinkFinderParams& p);
bool pinkIsDense(const PinkPatch& patch, const PinkFinderParams& p);
bool pinkIsNoBeacon(const PinkPatch& patch, const Landmarks& landmarks, const PinkFinderParams& p);
bool pinkIsLow(const Scene& scene, const PinkPatch& patch, const PinkFinderParams& p);
bool pinkIsInsideFieldEdge(const PinkPatch& patch, const PinkFinderParams& p);
bool pinkStandsOnGround(const PinkPatch& patch, const PinkFinderParams& p);

constexpr std::size_t kMaxPinkPatches = 8;
using PinkPatches = FixedVector<PinkPercept, kMaxPinkPatches>;
void findPinkPatches(const Scene& scene, const Landmarks& landmarks, const PinkFinderParams& params,
                     VisionCounts& counts, PinkPatches& patches);

}  // namespace kelpie::vision
