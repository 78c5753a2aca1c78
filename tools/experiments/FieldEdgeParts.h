// SPDX-License-Identifier: Apache-2.0
// The parts of the field-edge experiment.
#pragma once

#include "tools/experiments/Experiment.h"

namespace kelpie::experiments {

Json fieldEdgePoints(const ExperimentOptions& options);   // the fit on made-up points
Json fieldEdgeViews(const ExperimentOptions& options);    // vision on rendered views
Json fieldEdgeCorners(const ExperimentOptions& options);  // views with a corner of the carpet

}  // namespace kelpie::experiments
