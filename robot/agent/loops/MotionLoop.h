// SPDX-License-Identifier: Apache-2.0
// The motion loop: four sensed ticks and the current Command become four ticks of joint targets.
#pragma once

#include "actuator/Actuator.h"
#include "robot/agent/AgentConfig.h"
#include "robot/agent/loops/StageObserver.h"

namespace kelpie::agent {

class MotionLoop {
 public:
  explicit MotionLoop(const AgentConfig& config) : params_(config.actuator) {}

  const MotionOutput& step(const MotionInput& input, StageObserver& observer) {
    observer.begin(Stage::actuator);
    output_ = actuator::step(input, params_, state_);
    observer.end(Stage::actuator);
    return output_;
  }

 private:
  actuator::ActuatorParams params_;
  actuator::ActuatorState state_;
  MotionOutput output_;
};

}  // namespace kelpie::agent
