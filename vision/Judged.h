// SPDX-License-Identifier: Apache-2.0
// The candidates of an image that passed every check and were judged as a whole: what was known of
// them and the log odds against them, whether they were kept or not. For the fit of the log odds.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/GoalFacts.h"
#include "vision/RobotFinder.h"

namespace kelpie::vision {

struct JudgedGoal {
  LandmarkPercept percept;
  GoalFacts facts;
  double logOddsAgainst = 0.0;
};
struct JudgedRobot {
  RobotPercept percept;
  RobotFacts facts;
  double logOddsAgainst = 0.0;
};

struct Judged {
  JudgedGoals goals;
  JudgedRobots robots;
};

}  // namespace kelpie::vision
