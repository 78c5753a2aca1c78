// SPDX-License-Identifier: Apache-2.0
// The candidates for goals of an image that passed every check: what was known of them and the log
// odds against them, whether they were kept or not. For the fit of the log odds.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/goal/GoalFacts.h"

namespace kelpie::vision {

struct JudgedGoal {
  LandmarkPercept percept;
  GoalFacts facts;
  double logOddsAgainst = 0.0;
};
constexpr std::size_t kMaxJudgedGoals = 16;
using JudgedGoals = FixedVector<JudgedGoal, kMaxJudgedGoals>;

}  // namespace kelpie::vision
