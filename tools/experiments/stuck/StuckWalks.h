// SPDX-License-Identifier: Apache-2.0
// Walks in the simulated body with somebody holding it or not, without pixels: what effort tells,
// and what the localiser makes of it from odometry alone.
#pragma once

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {

// Thesis 2004 figure 2.10: the same command walked freely, half held and held; mean reported way
// and standard deviation of the filter, aware of being stuck and not.
Json heldWalks(const Request& request);

// Random walks held by random shares: hits and false alarms, and the calibration that they would
// give: the margin that free walking exceeds once in 200 messages, and the slowing k that explains
// the true ways best.
Json effortCalibration(const Request& request);

// Ten turns on weak legs: drift of the heading in percent of the turns reported, with the odometry
// of weak legs and with that of strong ones.
Json weakTurns(const Request& request);

}  // namespace kelpie::experiments
