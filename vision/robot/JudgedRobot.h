// SPDX-License-Identifier: Apache-2.0
// The candidates for robots of an image that passed every check; as JudgedGoal.h keeps those for
// goals.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/robot/RobotCurves.h"

namespace kelpie::vision {

struct JudgedRobot {
  RobotPercept percept;
  RobotFacts facts;
  double logOddsAgainst = 0.0;
};
constexpr std::size_t kMaxJudgedRobots = 8;
using JudgedRobots = FixedVector<JudgedRobot, kMaxJudgedRobots>;

}  // namespace kelpie::vision
