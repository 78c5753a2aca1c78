// SPDX-License-Identifier: Apache-2.0
#include "actuator/Reach.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

constexpr double kSeconds = 0.4;  // about a step
constexpr double kShare = kTickSeconds / kSeconds;
constexpr double kMost = 0.3;  // walks on varied models are within 0.15
// rad2 a tick, a twentieth of a quick walk's: less than half a step's worth says little.
constexpr double kLittle = 5e-5;

constexpr std::array<std::array<Joint, 2>, 3> kGroups = {
    {{Joint::leftFrontRotator, Joint::rightFrontRotator},
     {Joint::leftHindRotator, Joint::rightHindRotator},
     {Joint::leftFrontShoulder, Joint::rightFrontShoulder}}};

void lowPass(const LegPower& now, LegPower& mean) {
  for (std::size_t g = 0; g < mean.size(); ++g) mean[g] += kShare * (now[g] - mean[g]);
}

double reach(double asked, double done) {
  return maths::clamp(std::sqrt((done + kLittle) / (asked + kLittle)) - 1.0, -kMost, kMost);
}

}  // namespace

LegPower movedBy(const JointAngles& from, const JointAngles& to) {
  LegPower power{};
  for (std::size_t g = 0; g < kGroups.size(); ++g)
    for (const Joint joint : kGroups[g]) {
      const double moved = to[joint].rad() - from[joint].rad();
      if (std::isfinite(moved)) power[g] += moved * moved;
    }
  return power;
}

void stepReach(const LegPower& told, bool walks, const JointAngles& joints, ReachState& state) {
  lowPass(walks ? told : LegPower{}, state.asked);
  lowPass(walks ? movedBy(state.felt, joints) : LegPower{}, state.done);
  state.felt = joints;
}

Reach reachOf(const ReachState& state) {
  return {reach(state.asked[0], state.done[0]), reach(state.asked[1], state.done[1]),
          reach(state.asked[2], state.done[2])};
}

}  // namespace kelpie::actuator
