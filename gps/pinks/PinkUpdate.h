// SPDX-License-Identifier: Apache-2.0
// Corrects the modes by pink patches on the wall, whose heading alone is known and not which of the
// mapped ones they are (thesis 2004 section 4.1.3): each mode becomes one for each mapped patch and
// one uncorrected, M (N + 1) in all, of which the heaviest are kept.
#pragma once

#include "gps/pinks/PinkBearing.h"
#include "gps/pinks/PinkContext.h"
#include "gps/pinks/PinkState.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// Mapped patches of enough weight to be believed.
PinkLandmarks knownPinks(const PinkState& state, const PinkMapParams& params);

// One sighting. A corrected mode weighs w S / N (thesis 2004 equation 2.9, equal priors), the
// uncorrected copy w times modes.outlierWeight. A mode does not take a mapped patch at which the
// elevation cannot be. Call mergeAndPrune() afterwards. False without a map.
bool updateByPink(const PinkBearing& bearing, const PinkContext& context, PinkState& pinks,
                  Modes& modes);

// All patches of a frame, largest first, at most maxPatches; merges and prunes. Refuses what the
// best mode sees too high or too low for the wall: else spectators in pink would seem to show that
// it is lost.
void updateByPatches(const PinkBearings& bearings, const PinkContext& context, PinkState& pinks,
                     PoseState& pose, GpsCounts& counts);

}  // namespace kelpie::gps
