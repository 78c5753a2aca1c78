// SPDX-License-Identifier: Apache-2.0
// The walk, tick by tick: which set, how fast, where in the step. A change of set mixes the two
// over some ticks; nothing ever jumps.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/walk/WalkSpeed.h"
#include "robot/core/Time.h"

namespace kelpie::actuator {

struct WalkState {
  WalkKind kind = WalkKind::normal;  // that is walked, or mixed to
  WalkSet set;                       // as it is now
  WalkSet from;                      // as it was when the change began
  std::uint32_t mixTick = 0;
  bool chosen = false;  // a set has been taken up
  Velocity feet;        // the speed at which the feet move now
  PhaseState phase;
  // What was wanted for the last tick of this message, since a request beyond the feet takes half
  // of the tick to find out. Known: and the set is that of its kind, unmixed or mixed once more.
  WalkRequest request;
  Velocity wanted;
  bool known = false;
};

void stepWalk(const WalkRequest& request, const ActuatorParams& params, WalkState& state);

// Suspends the walk for a motion: the feet have stopped.
void stopWalk(WalkState& state);

inline bool standing(const WalkState& state) { return standing(state.phase) && still(state.feet); }

// No foot is high: a motion may begin.
bool betweenSteps(const WalkState& state);

}  // namespace kelpie::actuator
