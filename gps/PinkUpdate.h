// SPDX-License-Identifier: Apache-2.0
// Corrects the modes by pink patches on the wall, whose heading alone is known and not which of the
// mapped ones they are (thesis 2004 section 4.1.3): each mode becomes one for each mapped patch and
// one uncorrected, M (N + 1) in all, of which the heaviest are kept.
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "robot/core/Percepts.h"

namespace kelpie::gps {

// Mapped patches of enough weight to be believed.
PinkLandmarks knownPinks(const PinkState& state, const PinkParams& params);

// One sighting. A corrected mode weighs w S / N (equation 2.9, equal priors), the uncorrected copy
// w times modes.noiseWeight. A mode does not take a mapped patch at which the elevation cannot be.
// Call tidy() afterwards. False when nothing was done: no map, or a percept that cannot be used.
bool updateByPink(const PinkPercept& percept, const GpsParams& params, GpsState& state);

// All patches of a frame, largest first, at most maxPatches; tidies.
void updateByPatches(const FixedVector<PinkPercept, 8>& patches, const GpsParams& params,
                     GpsState& state);

}  // namespace kelpie::gps
