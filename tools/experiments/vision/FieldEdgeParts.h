// SPDX-License-Identifier: Apache-2.0
// The parts of the field-edge experiment.
#pragma once

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {

Json fieldEdgePoints(const Request& request);   // the fit on made-up points
Json fieldEdgeViews(const Request& request);    // vision on rendered views
Json fieldEdgeCorners(const Request& request);  // views with a corner of the carpet

}  // namespace kelpie::experiments
