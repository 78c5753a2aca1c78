// SPDX-License-Identifier: Apache-2.0
// What a calibration reads of an agent's log: its configuration, and one frame's input after the
// other. A log that is cut off gives what can be read of it, and says what it lacks.
#pragma once

#include <memory>
#include <string>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/log/FrameMessages.h"
#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::calibrate {

// Calls take(message), which returns a Status, for every message but the configuration, which comes
// before them. `lacks` is what of the log could not be read. An error is one line that begins with
// the log's name.
template <class Take>
Status forEachMessage(const std::string& path, agent::AgentConfig& config, std::string& lacks,
                      Take&& take) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  bool configured = false;
  while (reader->next(message)) {
    const bool isConfig = message.topic() == kConfigTopic;
    configured = configured || isConfig;
    const Status done = isConfig ? decodeAs(message, config) : take(message);
    if (!done) return Error{path + ": " + done.error()};
  }
  if (!reader->status()) return reader->status();
  lacks = reader->lacks();
  if (!configured) return Error{path + ": not a log of an agent"};
  return Done{};
}

// Calls take(input, image kept) for every frame.
template <class Take>
Status forEachFrame(const std::string& path, agent::AgentConfig& config, std::string& lacks,
                    Take&& take) {
  const auto input = std::make_unique<FrameInput>();
  return forEachMessage(path, config, lacks, [&](const LogMessage& message) -> Status {
    if (!agent::isFrameInput(message.topic())) return Done{};
    const Status done = agent::decodeFrameInput(message, *input);
    if (done) take(*input, message.topic() != kPictureFrameTopic);
    return done;
  });
}

}  // namespace kelpie::calibrate
