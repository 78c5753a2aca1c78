// SPDX-License-Identifier: Apache-2.0
// What a log tells of the decisions of its robot, frame by frame. Frames that are damaged are
// passed over.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::match {

struct Decision {
  double seconds = 0.0;  // middle of the exposure
  std::uint32_t frame = 0;
  bool driven = false;  // by a person: the behaviours were not asked
  const Command& command;
  const WorldModel& world;  // what it was made from
};

struct Span {
  double from = 0.0;  // s
  double to = 0.0;
};

struct DecisionLog {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  std::size_t frames = 0;  // in the whole log
  double first = 0.0;      // s, of these
  double last = 0.0;
  std::string lacks;  // a complaint when not all of the log could be read
};

// Shows every decision within the span. An error when the file is no log, or holds no outputs.
Expected<DecisionLog> readDecisions(const std::string& log, const Span& span,
                                    const std::function<void(const Decision&)>& visit);

}  // namespace kelpie::match
