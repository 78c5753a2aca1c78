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

// Calls take(input, image kept) for every frame; the configuration comes before them. `lacks` is
// what of the log could not be read. An error is one line that begins with the log's name.
template <class Take>
Status forEachFrame(const std::string& path, agent::AgentConfig& config, std::string& lacks,
                    Take&& take) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  const auto input = std::make_unique<FrameInput>();
  bool configured = false;
  while (reader->next(message)) {
    Status done = Done{};
    if (message.topic() == kConfigTopic) {
      done = decodeAs(message, config);
      configured = true;
    } else if (agent::isFrameInput(message.topic())) {
      done = agent::decodeFrameInput(message, *input);
      if (done) take(*input, message.topic() != kPictureFrameTopic);
    }
    if (!done) return Error{path + ": " + done.error()};
  }
  if (!reader->status()) return reader->status();
  lacks = reader->lacks();
  if (!configured) return Error{path + ": not a log of an agent"};
  return Done{};
}

}  // namespace kelpie::calibrate
