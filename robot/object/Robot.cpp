// SPDX-License-Identifier: Apache-2.0
#include "robot/object/Robot.h"

#include "robot/agent/AgentLoops.h"

namespace kelpie::object {
namespace {

// The loops with what they write to: on a robot nobody listens.
class RobotLoops : public agent::Loops {
 public:
  explicit RobotLoops(const agent::AgentConfig& config) : loops_(config, {}, silent_) {}

  const MotionOutput& motion(const MotionInput& withoutCommand) override {
    return loops_.motion(withoutCommand);
  }
  void camera(const Image& image, TimeUs exposureMiddle, std::uint32_t number) override {
    loops_.camera(image, exposureMiddle, number);
  }

 private:
  agent::LogSink silent_;
  agent::AgentLoops loops_;
};

}  // namespace

std::unique_ptr<agent::AgentConfig> makeConfig() { return std::make_unique<agent::AgentConfig>(); }

std::unique_ptr<agent::Loops> makeLoops(const agent::AgentConfig& config) {
  return std::make_unique<RobotLoops>(config);
}

}  // namespace kelpie::object
