// SPDX-License-Identifier: Apache-2.0
// What an agent would answer a world that sends its joints so: for whoever drives a body by the
// actuator alone, without an OPEN-R object between.
#pragma once

#include "robot/core/types/Motion.h"
#include "robot/host/primitives/RawFrame.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {

// All joints powered; `legGain` as AgentReply has it.
inline AgentReply ordersOf(const std::array<JointFrame, kTicksPerMessage>& joints, double legGain) {
  AgentReply reply;
  reply.motorPower = true;
  reply.gains = kAllJoints;
  reply.legGain = legGain;
  EffectorVector vector;
  vector.ticks = kTicksPerMessage;
  vector.joints = kAllJoints;
  for (std::size_t i = 0; i < joints.size(); ++i) vector.targets[i] = rawOf(joints[i].target);
  reply.vectors.push_back(vector);
  return reply;
}

}  // namespace kelpie::host
