// SPDX-License-Identifier: Apache-2.0
// The candidates for balls of an image that passed every check; as JudgedGoal.h keeps those for
// goals.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/ball/BallCurves.h"

namespace kelpie::vision {

struct JudgedBall {
  BallPercept percept;
  BallFacts facts;
  double logOddsAgainst = 0.0;
};
constexpr std::size_t kMaxJudgedBalls = 16;
using JudgedBalls = FixedVector<JudgedBall, kMaxJudgedBalls>;

}  // namespace kelpie::vision
