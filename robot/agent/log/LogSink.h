// SPDX-License-Identifier: Apache-2.0
// Where the loops put what they read and made. On the robot nobody listens.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "robot/core/types/Motion.h"

namespace kelpie::agent {

class LogSink {
 public:
  virtual ~LogSink() = default;
  virtual void motion(const MotionInput&, const MotionOutput&) {}
  virtual void frame(const FrameInput&, const FrameOutput&) {}
};

}  // namespace kelpie::agent
