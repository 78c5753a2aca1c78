// SPDX-License-Identifier: Apache-2.0
// The log odds against a goal by its facts, as they were learned; tools/curves can write
// GoalCurves.cpp anew.
#pragma once

#include "vision/goal/GoalFacts.h"

namespace kelpie::vision {

// Natural log of the odds against a goal, up to a constant.
double logOddsAgainst(const GoalFacts& facts);

}  // namespace kelpie::vision
