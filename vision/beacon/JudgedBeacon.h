// SPDX-License-Identifier: Apache-2.0
// The candidates for beacons of an image that passed every check; as JudgedGoal.h keeps those for
// goals.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/beacon/BeaconCurves.h"

namespace kelpie::vision {

struct JudgedBeacon {
  LandmarkPercept percept;
  BeaconFacts facts;
  double logOddsAgainst = 0.0;
};
constexpr std::size_t kMaxJudgedBeacons = 16;
using JudgedBeacons = FixedVector<JudgedBeacon, kMaxJudgedBeacons>;

}  // namespace kelpie::vision
