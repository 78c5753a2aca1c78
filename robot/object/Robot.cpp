// SPDX-License-Identifier: Apache-2.0
#include "robot/object/Robot.h"

#include <new>

namespace kelpie::object {

std::unique_ptr<agent::AgentConfig> makeConfig() { return std::make_unique<agent::AgentConfig>(); }

LateLoops::~LateLoops() {
  if (made()) storage_.loops.~RobotLoops();
}

void LateLoops::make(const agent::AgentConfig& config, const std::string& scripts) {
  if (made()) return;
  at_ = new (&storage_.loops) RobotLoops(config, scripts);
  at_->power(power_);
}

void LateLoops::refuse(std::uint8_t fault) { fault_.setFault(fault); }

}  // namespace kelpie::object
