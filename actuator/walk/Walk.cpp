// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/Walk.h"

#include <array>
#include <cmath>
#include <cstring>

namespace kelpie::actuator {
namespace {

std::uint32_t mixTicks(const ActuatorParams& params) {
  return static_cast<std::uint32_t>(params.mixSeconds / kTickSeconds + 0.5);
}

void choose(WalkKind kind, const ActuatorParams& params, WalkState& state) {
  state.known = state.known && state.chosen && kind == state.kind;
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
  if (share < 1.0) {
    state.set = mixed(state.from, target, share);
  } else {
    state.set = target;
  }
}

// Bit by bit, as -0 is not 0 for what is made of it.
bool same(const WalkRequest& a, const WalkRequest& b) {
  const std::array<double, 4> one{a.forward, a.left, a.turn, a.pivot};
  const std::array<double, 4> other{b.forward, b.left, b.turn, b.pivot};
  return std::memcmp(one.data(), other.data(), sizeof one) == 0;
}

}  // namespace

void stepWalk(const WalkRequest& request, const ActuatorParams& params, WalkState& state) {
  choose(request.kind, params, state);
  const bool setStays = state.known && state.mixTick >= mixTicks(params);
  if (!setStays) mixSets(params, state);
  if (!setStays || !same(request, state.request)) state.wanted = wantedSpeed(request, state.set);
  state.request = request;
  state.known = true;
  state.feet = approached(state.feet, state.wanted, state.set.gait);
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
