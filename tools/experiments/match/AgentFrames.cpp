// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/match/AgentFrames.h"

#include <memory>

#include "robot/agent/log/FrameMessages.h"

namespace kelpie::experiments {

Status eachAgentFrame(const std::string& log, const AgentFrame& frame) {
  auto reader = LogReader::open(log);
  if (!reader) return Error{reader.error()};
  const auto input = std::make_unique<FrameInput>();
  const auto output = std::make_unique<FrameOutput>();
  LogMessage message;
  bool known = false;
  while (reader->next(message)) {
    if (agent::isFrameInput(message.topic())) known = agent::decodeFrameInput(message, *input).ok();
    if (message.topic() != kFrameOutputTopic || !known || !decodeAs(message, *output)) continue;
    frame(*input, *output);
  }
  return reader->status();
}

}  // namespace kelpie::experiments
