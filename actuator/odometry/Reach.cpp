// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/Reach.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

constexpr double kSeconds = 0.4;  // about a step
constexpr double kShare = kTickSeconds / kSeconds;
constexpr double kMax = 0.3;  // walks on varied models are within 0.15
// rad2 a tick, a twentieth of a quick walk's: less than half a step says little, and the
// sensors' noise is a twentieth of it.
constexpr double kLittle = 1e-4;

void lowPass(const LegPower& now, LegPower& mean) {
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += kShare * (now[i] - mean[i]);
}

double reach(double asked, double done) {
  return maths::clamp(std::sqrt((done + kLittle) / (asked + kLittle)) - 1.0, -kMax, kMax);
}

SideReach ofSide(std::size_t first, const ReachState& state) {
  const auto at = [&](std::size_t i) {
    return reach(state.asked[first + i], state.done[first + i]);
  };
  return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

}  // namespace

LegPower movedBy(const JointAngles& from, const JointAngles& to) {
  LegPower power{};
  const std::size_t first = index(Joint::leftFrontRotator);
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double moved = to.angle[first + i].rad() - from.angle[first + i].rad();
    if (std::isfinite(moved)) power[i] = moved * moved;
  }
  return power;
}

void stepReach(const LegPower& commanded, bool walks, const JointAngles& joints,
               ReachState& state) {
  lowPass(walks ? commanded : LegPower{}, state.asked);
  lowPass(walks ? movedBy(state.felt, joints) : LegPower{}, state.done);
  state.felt = joints;
}

Reach reachOf(const ReachState& state) { return {ofSide(0, state), ofSide(6, state)}; }

}  // namespace kelpie::actuator
