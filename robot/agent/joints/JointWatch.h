// SPDX-License-Identifier: Apache-2.0
// Whether a joint that is held does not go where it was commanded: a broken gear, or something that
// blocks it for longer than a scrum does. Compares what is sensed with what was commanded
// kWatchedMessages before. Fails where all of a joint's way is short.
#pragma once

#include <array>
#include <optional>

#include "robot/core/types/Motion.h"

namespace kelpie::agent {

struct JointWatchParams {
  double apart = 45.0;   // deg; a kick leaves a joint that far behind for 0.3 s
  double seconds = 2.0;  // without a break
};

constexpr std::size_t kWatchedMessages = 4;  // two vectors in flight, and the servo's lag

struct JointWatchState {
  std::array<JointAngles, kWatchedMessages> commanded{};  // the oldest at `next`
  std::size_t next = 0;
  std::uint32_t messages = 0;               // known
  std::array<double, kJointCount> apart{};  // s
  std::optional<Joint> stuck;               // until no joint is held any more
};

// Before the targets of this message are commanded. The joint that has been apart for so long; it
// counts as stuck until all joints are limp, wherever the robot lies down meanwhile.
std::optional<Joint> step(const MotionInput& in, const JointWatchParams& params,
                          JointWatchState& state);
void commanded(const JointAngles& targets, JointWatchState& state);

}  // namespace kelpie::agent
