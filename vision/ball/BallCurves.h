// SPDX-License-Identifier: Apache-2.0
// The log odds against a ball by its facts, as they were learned: BallCurves.cpp is written by
// tools/curves.
#pragma once

#include "vision/ball/BallFacts.h"

namespace kelpie::vision {

// Natural log of the odds against a ball, up to a constant.
double logOddsAgainst(const BallFacts& facts);

}  // namespace kelpie::vision
