// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/Lie.h"

#include <cmath>

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

void keepAsFound(const MotionInput& in, JointAngles& target) {
  const JointAngles& sensed = in.sensors.back().joints;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool held = (in.held >> j & 1U) != 0;
    if (!held && std::isfinite(sensed.angle[j].rad())) target.angle[j] = sensed.angle[j];
  }
}

void breakOff(ActuatorState& state) {
  stopWalk(state.walk);
  state.blend = {};
  if (!running(state.motion)) return;
  state.motion = {};
  state.motion.answered = true;
}

}  // namespace

void stepRest(const MotionInput& in, const ActuatorParams& params, ActuatorState& state) {
  const bool found = staysAsFound(in.rest);
  const bool lies = in.rest != Rest::none && !found;
  if (found) keepAsFound(in, state.target);
  if (found == state.found && lies == state.lies) return;
  state.found = found;
  state.lies = lies;
  breakOff(state);
  begin(params, state.approach);
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
