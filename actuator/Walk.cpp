// SPDX-License-Identifier: Apache-2.0
#include "actuator/Walk.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

std::uint32_t mixTicks(const ActuatorParams& params) {
  return static_cast<std::uint32_t>(params.mixSeconds / kTickSeconds + 0.5);
}

void choose(WalkKind kind, const ActuatorParams& params, WalkState& state) {
  if (state.chosen && kind != state.kind) {
    state.from = state.set;
    state.mixTick = 0;
  } else if (!state.chosen) {
    state.mixTick = mixTicks(params);
  }
  state.kind = kind;
  state.chosen = true;
}

void mixSets(const ActuatorParams& params, WalkState& state) {
  const std::uint32_t all = mixTicks(params);
  const WalkSet& target = walkSet(params.walks, state.kind);
  if (state.mixTick < all) ++state.mixTick;
  const double share = all == 0 ? 1.0 : static_cast<double>(state.mixTick) / all;
  state.set = mixed(state.from, target, share);
}

}  // namespace

void stepWalk(const WalkRequest& request, const ActuatorParams& params, WalkState& state) {
  choose(request.kind, params, state);
  mixSets(params, state);
  const Velocity wanted = wantedSpeed(request, state.set);
  state.feet = approached(state.feet, wanted, state.set.gait);
  // A robot that changes its stance steps, else it would drag its feet.
  const bool changes = state.mixTick < mixTicks(params);
  stepPhase(!still(state.feet) || changes, state.set.gait, state.phase);
}

void stopWalk(WalkState& state) {
  state.feet = {};
  state.phase.lift = 0.0;
}

bool betweenSteps(const WalkState& state) {
  constexpr double kNear = 0.06;  // of a step: 3 ticks of 44
  if (standing(state.phase)) return true;
  const double part = state.phase.phase < 0.5 ? state.phase.phase : state.phase.phase - 0.5;
  return part < kNear;
}

}  // namespace kelpie::actuator
