// SPDX-License-Identifier: Apache-2.0
// The match tables of thesis 2004 section 3.2.2 on a field as in Lisbon, where the ground beyond
// the border is green up to an outer wall: those of the home field and those with the outer border,
// each by both match functions. Made views of robots near the border, without other robots and
// goals.
#pragma once

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {

// From each start (FromAGuess.h) the thesis' ascent on each of the four sets of tables; and their
// match at the true pose, which is 1 without errors where the tables are those of the ground.
Json lisbonTables(const Request& request);

}  // namespace kelpie::experiments
