// SPDX-License-Identifier: Apache-2.0
// Every mode against every pose that the lines cannot tell from the one that they gave (thesis 2004
// section 3.3.3: m modes times n observation modes). Only modes so wide that another such pose lies
// within them gain anything by it.
#pragma once

#include "gps/lines/LinesParams.h"
#include "gps/lines/Symmetry.h"
#include "gps/pose/PoseState.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {

// The heaviest products, `SymmetryParams::maxPoses` at most, of the modes as they are before the
// update and the poses that look like `found`, the heaviest mode's; each is weighted by its match
// over that of `found`. None unless SymmetryParams::use.
FixedVector<PoseMode, kMaxAmbiguousPoses> symmetricModes(const SeenLines& seen,
                                                         const PoseObservation& found,
                                                         const PaintedField& field,
                                                         const LinesParams& params,
                                                         const Modes& modes);

}  // namespace kelpie::gps
