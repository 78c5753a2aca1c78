// SPDX-License-Identifier: Apache-2.0
#include "robot/object/Robot.h"

#include <new>

namespace kelpie::object {

std::unique_ptr<agent::AgentConfig> makeConfig() { return std::make_unique<agent::AgentConfig>(); }

LateLoops::~LateLoops() {
  if (made_) room_.loops.~RobotLoops();
}

void LateLoops::make(const agent::AgentConfig& config) {
  if (made_) return;
  new (&room_.loops) RobotLoops(config);
  made_ = true;
}

}  // namespace kelpie::object
