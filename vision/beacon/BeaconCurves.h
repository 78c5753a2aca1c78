// SPDX-License-Identifier: Apache-2.0
// The log odds against a beacon by its facts, as they were learned: BeaconCurves.cpp is written by
// tools/curves.
#pragma once

#include "vision/beacon/BeaconFacts.h"

namespace kelpie::vision {

// Natural log of the odds against a beacon, up to a constant.
double logOddsAgainst(const BeaconFacts& facts);

}  // namespace kelpie::vision
