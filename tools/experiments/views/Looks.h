// SPDX-License-Identifier: Apache-2.0
// Random views one after the other, each as vision with its default parameters sees it.
#pragma once

#include <functional>

#include "robot/core/types/Percepts.h"
#include "tools/experiments/views/View.h"
#include "vision/ball/JudgedBall.h"
#include "vision/beacon/JudgedBeacon.h"
#include "vision/goal/JudgedGoal.h"
#include "vision/robot/JudgedRobot.h"

namespace kelpie::experiments {

struct Look {
  int number = 0;  // from 0
  const View& view;
  const BodyState& body;
  const Percepts& seen;
  const vision::JudgedBalls& judgedBalls;
  const vision::JudgedBeacons& judgedBeacons;
  const vision::JudgedGoals& judgedGoals;
  const vision::JudgedRobots& judgedRobots;
};

// Calls use(look) for one view a trial.
void lookAtViews(const ViewParams& params, const Request& request,
                 const std::function<void(const Look&)>& use);

}  // namespace kelpie::experiments
