// SPDX-License-Identifier: Apache-2.0
// The log odds against a robot by its facts, as they were learned: RobotCurves.cpp is written by
// tools/curves.
#pragma once

#include "vision/robot/RobotFacts.h"

namespace kelpie::vision {

// Natural log of the odds against a robot, up to a constant.
double logOddsAgainst(const RobotFacts& facts);

}  // namespace kelpie::vision
