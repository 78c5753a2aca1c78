// SPDX-License-Identifier: Apache-2.0
// Ring correction on the genuine ERS-7 frames: how uneven their green carpet looks by distance,
// raw, with the 2006 polynomial, with a real robot's 2005 table, and with one learnt from these
// frames. Another robot than either table's, and a carpet is not an evenly lit sheet.
#pragma once

#include "tools/cli/Figures.h"

namespace kelpie::experiments {

cli::Json genuineFrames();  // null with a note where ../shared/data is absent

}  // namespace kelpie::experiments
