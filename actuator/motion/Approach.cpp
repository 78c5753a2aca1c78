// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/Approach.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

double longestWay(const JointAngles& from, const JointAngles& to) {
  double longest = 0.0;
  for (std::size_t j = 0; j < kJointCount; ++j)
    longest = std::fmax(longest, std::fabs(to.angle[j].rad() - from.angle[j].rad()));
  return longest;
}

}  // namespace

void begin(const ActuatorParams& params, ApproachState& state) {
  state = {true, static_cast<std::uint32_t>(params.rampSeconds / kTickSeconds + 0.5)};
}

JointAngles approached(const JointAngles& pose, const JointAngles& now,
                       const ActuatorParams& params, ApproachState& state) {
  const double max = params.startRate.rad() * kTickSeconds;
  const double way = longestWay(now, pose);
  if (state.ticks <= 1 && way <= max) {
    state = {};
    return pose;
  }
  const double share = std::fmin(1.0 / std::fmax(state.ticks, 1.0), max / std::fmax(way, max));
  if (state.ticks > 1) --state.ticks;
  JointAngles next;
  for (std::size_t j = 0; j < kJointCount; ++j)
    next.angle[j] = partWay(now.angle[j], pose.angle[j], share);
  return next;
}

}  // namespace kelpie::actuator
