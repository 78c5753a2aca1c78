// SPDX-License-Identifier: Apache-2.0
// An agent's reply that drives all joints, powered and with full gains, to one posture.
#pragma once

#include "robot/host/world/WorldProtocol.h"

namespace kelpie::sim {

inline host::AgentReply targets(const JointAngles& joints) {
  host::AgentReply reply;
  reply.motorPower = true;
  reply.gains = (1U << kJointCount) - 1U;
  host::EffectorVector vector;
  vector.ticks = 1;
  vector.joints = reply.gains;
  vector.targets[0] = host::rawOf(joints);
  reply.vectors.push_back(vector);
  return reply;
}

}  // namespace kelpie::sim
