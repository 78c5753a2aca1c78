// SPDX-License-Identifier: Apache-2.0
// The update by field lines, and then every mode against every pose that the lines cannot tell from
// the one that they gave (thesis 2004 section 3.3.3: m modes times n observation modes). Kept to
// repeat that it gains nothing: only modes so wide that another such pose lies within them could
// gain anything by it.
#pragma once

#include "gps/pose/PoseState.h"
#include "tools/experiments/baselines/Symmetry.h"

namespace kelpie::gps {

// As updateByLines(). Added are the heaviest products, `SymmetryParams::maxPoses` at most, of the
// modes as they were before and the poses that look like that found near the heaviest; each is
// weighted by its match over that of the found one.
bool updateByLinesAndSymmetry(const SeenLines& seen, const PaintedField& field,
                              const LineUpdateParams& params, Modes& modes, GpsCounts& counts);

}  // namespace kelpie::gps
