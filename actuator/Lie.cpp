// SPDX-License-Identifier: Apache-2.0
#include "actuator/Lie.h"

#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

// As the goalie lies in its block (actuator/data/motions/block.toml), which none of five varied
// physical models fell from: on the belly, forelegs wide, the head low and clear of the chest.
constexpr std::array<double, 3> kFront = {10.0, 85.0, 0.0};   // deg: rotator, shoulder, knee
constexpr std::array<double, 3> kHind = {-30.0, 40.0, 60.0};  // so
constexpr double kNeckTilt = -60.0;                           // deg
constexpr double kHeadNod = 20.0;
constexpr double kMouthShut = -3.0;

void setLeg(LegId leg, const std::array<double, 3>& pose, JointAngles& target) {
  for (std::size_t j = 0; j < pose.size(); ++j)
    target.angle[firstJoint(leg) + j] = Angle::deg(pose[j]);
}

}  // namespace

void stepLie(Rest rest, const ActuatorParams& params, ActuatorState& state) {
  const bool lies = rest != Rest::none;
  if (lies == state.lies) return;
  state.lies = lies;
  stopWalk(state.walk);
  if (running(state.motion)) {
    state.motion = {};
    state.motion.answered = true;
  }
  const double ticks = params.rampSeconds / kTickSeconds + 0.5;
  state.blend = {state.target, 0, static_cast<std::uint32_t>(ticks)};
}

void lieDown(JointAngles& target) {
  setLeg(LegId::leftFront, kFront, target);
  setLeg(LegId::rightFront, kFront, target);
  setLeg(LegId::leftHind, kHind, target);
  setLeg(LegId::rightHind, kHind, target);
  target[Joint::neckTilt] = Angle::deg(kNeckTilt);
  target[Joint::headPan] = Angle();
  target[Joint::headNod] = Angle::deg(kHeadNod);
  target[Joint::mouth] = Angle::deg(kMouthShut);
}

}  // namespace kelpie::actuator
