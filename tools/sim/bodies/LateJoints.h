// SPDX-License-Identifier: Apache-2.0
// A robot whose joints tell where they were some time ago: keeps what they felt in the last ticks.
// Before there was so much of it, the first is told.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "robot/core/types/Motion.h"
#include "tools/sim/bodies/Bodies.h"

namespace kelpie::sim {

class LateJoints {
 public:
  explicit LateJoints(double frames)
      : late_(static_cast<std::size_t>(std::lround(frames * kFrameSeconds / kTickSeconds))) {}

  // What is felt in this tick, once a tick; what is told in it.
  const JointAngles& tell(const JointAngles& felt) {
    felt_[ticks_ % felt_.size()] = felt;
    const std::size_t late = std::min({late_, ticks_, felt_.size() - 1});
    return felt_[(ticks_++ - late) % felt_.size()];
  }

 private:
  std::size_t late_;  // ticks
  std::array<JointAngles, 16> felt_{};
  std::size_t ticks_ = 0;
};

}  // namespace kelpie::sim
