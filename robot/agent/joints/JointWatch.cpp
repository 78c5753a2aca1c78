// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/joints/JointWatch.h"

#include <cmath>

namespace kelpie::agent {

std::optional<Joint> step(const MotionInput& in, const JointWatchParams& params,
                          JointWatchState& state) {
  constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
  const JointAngles& then = state.commanded[state.next];
  const JointAngles& now = in.sensors.back().joints;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double error = std::fabs((now.angle[j] - then.angle[j]).deg());
    const bool held = (in.held >> j & 1U) != 0 && state.messages >= kWatchedMessages;
    state.apart[j] = held && error > params.apart ? state.apart[j] + kMessageSeconds : 0.0;
    if (state.apart[j] >= params.seconds) state.stuck = static_cast<Joint>(j);
  }
  if (in.held == 0) state.stuck.reset();
  return state.stuck;
}

void commanded(const JointAngles& targets, JointWatchState& state) {
  state.commanded[state.next] = targets;
  state.next = (state.next + 1) % kWatchedMessages;
  if (state.messages < kWatchedMessages) ++state.messages;
}

}  // namespace kelpie::agent
