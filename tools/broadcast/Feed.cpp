// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Feed.h"

#include "robot/agent/log/FrameMessages.h"
#include "tools/cli/log/Logs.h"

namespace kelpie::broadcast {

Expected<Feed> Feed::open(const std::string& path) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  while (reader->next(message)) {
    if (message.topic() != kConfigTopic) continue;
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return Error{path + ": " + read.error()};
    return Expected<Feed>(Feed(std::move(*reader), config->team, config->player));
  }
  if (!reader->status()) return Error{reader->status().error()};
  return Error{path + ": holds no frames with outputs to show"};
}

void Feed::step() {
  if (agent::isFrameInput(message_.topic())) {
    inputKnown_ = cli::decodeForPeople(message_, *input_).ok();
    fresh_ = cli::hasImage(message_);
  }
  if (message_.topic() == kFrameOutputTopic && inputKnown_ && decodeAs(message_, *output_))
    any_ = true;
}

void Feed::advance(double seconds) {
  while (pending_ || reader_.next(message_)) {
    pending_ = message_.time.seconds() > seconds;
    if (pending_) return;
    step();
  }
}

}  // namespace kelpie::broadcast
