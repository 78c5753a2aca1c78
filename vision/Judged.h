// SPDX-License-Identifier: Apache-2.0
// The candidates of an image that passed every check and were judged as a whole: what was known of
// them and how doubtful they are, whether they were kept or not. For the fit of those judgements.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/GoalDoubt.h"
#include "vision/RobotFinder.h"

namespace kelpie::vision {

struct JudgedGoal {
  LandmarkPercept percept;
  GoalFacts facts;
  double doubt = 0.0;  // log odds
};
struct JudgedRobot {
  RobotPercept percept;
  RobotFacts facts;
  double doubt = 0.0;
};

struct Judged {
  JudgedGoals goals;
  JudgedRobots robots;
};

}  // namespace kelpie::vision
