// SPDX-License-Identifier: Apache-2.0
// Corrects the modes by pink patches on the wall, whose heading alone is known and not which of the
// mapped ones they are (thesis 2004 section 4.1.3): each mode becomes one for each mapped patch and
// one uncorrected, M (N + 1) in all, of which the heaviest are kept.
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/PinkBearing.h"

namespace kelpie::gps {

// Mapped patches of enough weight to be believed.
PinkLandmarks knownPinks(const PinkState& state, const PinkMapParams& params);

// One sighting. A corrected mode weighs w S / N (equation 2.9, equal priors), the uncorrected copy
// w times modes.outlierWeight. A mode does not take a mapped patch at which the elevation cannot
// be. Call mergeAndPrune() afterwards. False without a map.
bool updateByPink(const PinkBearing& bearing, const GpsParams& params, GpsState& state);

// All patches of a frame, largest first, at most maxPatches; tidies. Refuses what the best mode
// sees too high or too low for the wall: else spectators in pink would seem to show that it is
// lost.
void updateByPatches(const PinkBearings& bearings, const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
