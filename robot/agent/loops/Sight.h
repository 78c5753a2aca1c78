// SPDX-License-Identifier: Apache-2.0
// What may stand in the place of vision where no image is rendered, as in a simulated match of
// percepts (tools/percepts). On the robot nothing does.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::agent {

class Sight {
 public:
  virtual ~Sight() = default;

  // Replaces all percepts by those of this frame.
  virtual void see(const FrameInput& input, const BodyState& body, Percepts& percepts) = 0;
};

}  // namespace kelpie::agent
