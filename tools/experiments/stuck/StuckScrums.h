// SPDX-License-Identifier: Apache-2.0
// Scrums: a robot that plays is held, pushed and turned for some seconds while it walks on, again
// and again. Localisers with and without awareness of being stuck, with and without a pause of the
// lines, with lines and landmarks in one update or two, listen to the same matches.
#pragma once

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {

// For each localiser: error and standard deviation when the scrum ends, seconds from then until the
// error stays below 30 cm until the next scrum.
Expected<Json> scrums(const Request& request);

}  // namespace kelpie::experiments
