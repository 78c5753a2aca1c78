// SPDX-License-Identifier: Apache-2.0
// A ball with robots at it that goes nowhere: within stuckDistance of one place for stuckTime while
// somebody is within stuckReach of it. A ball that nobody is at is not stuck; its clock begins anew
// when somebody comes.
#pragma once

#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

struct StuckState {
  std::optional<TimeUs> since;
  Point2<Field> place;
};

bool step(const MatchScene& scene, const body::Rules& rules, StuckState& state);

}  // namespace kelpie::sim
