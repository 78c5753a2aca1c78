// SPDX-License-Identifier: Apache-2.0
// A robot that holds the ball longer than holdingTime or carries it farther than holdingDistance
// (checklist A-6.4.1.1); what a hold is says HoldWatch. A ball that is let go for less than 0.1 s
// is held on.
#pragma once

#include <array>

#include "tools/sim/bodies/HoldWatch.h"
#include "tools/sim/rules/Fouls.h"

namespace kelpie::sim {

struct HoldingState {
  std::array<HoldWatch, kMaxRobots> watches;
};

Fouls step(const MatchScene& scene, const body::Rules& rules, HoldingState& state);

}  // namespace kelpie::sim
