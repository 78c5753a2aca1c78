// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/CommandQueue.h"

#include <algorithm>

#include "robot/body/Legs.h"

namespace kelpie::sim {
namespace {

// A command queue deeper than this is a runaway agent; OPEN-R programs keep two.
constexpr std::size_t kMaxQueue = 16;

}  // namespace

void CommandQueue::add(const host::AgentReply& reply) {
  motorPower_ = reply.motorPower;
  gains_ = reply.gains;
  if (motorPower_ && gains_ == kAllJoints) handHolds_ = false;
  legGain_ = reply.legGain;
  for (const host::EffectorVector& vector : reply.vectors) {
    if (queue_.size() < kMaxQueue && vector.ticks > 0) queue_.push_back(vector);
  }
}

void CommandQueue::play() {
  if (queue_.empty()) return;
  const host::EffectorVector& vector = queue_.front();
  const JointAngles wanted =
      host::anglesOf(vector.targets[std::min<std::size_t>(played_, host::kMaxVectorTicks - 1)]);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    if ((vector.joints >> j & 1U) != 0) target_.angle[j] = wanted.angle[j];
  }
  target_ = body::withinLimits(target_);
  if (++played_ < vector.ticks) return;
  queue_.pop_front();
  played_ = 0;
  ++done_;
}

std::uint32_t CommandQueue::takeVectorsDone() {
  const std::uint32_t done = done_;
  done_ = 0;
  return done;
}

}  // namespace kelpie::sim
