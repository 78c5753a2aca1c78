// SPDX-License-Identifier: Apache-2.0
#include "tools/match/Decisions.h"

#include <fmt/core.h>

#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "tools/cli/log/Logs.h"

namespace kelpie::match {
namespace {

class Reading {
 public:
  Reading(const Span& span, const std::function<void(const Decision&)>& visit)
      : span_(span), visit_(visit) {}

  Status take(const LogMessage& message) {
    const double seconds = message.time.seconds();
    const bool within = seconds >= span_.from && seconds <= span_.to;
    if (message.topic() == kConfigTopic) return configure(message);
    if (agent::isFrameInput(message.topic()) && within)
      inputKnown_ = agent::decodeFrameInput(message, *input_).ok();
    if (message.topic() != kFrameOutputTopic) return Done{};
    if (found.frames++ == 0) found.first = seconds;
    found.last = seconds;
    if (within && decodeAs(message, *output_))
      visit_({seconds, output_->frame, inputKnown_ && input_->drive.present, output_->command,
              output_->world});
    inputKnown_ = false;
    return Done{};
  }

  DecisionLog found;

 private:
  Status configure(const LogMessage& message) {
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    found.team = config->team;
    found.player = config->player;
    return read;
  }

  Span span_;
  const std::function<void(const Decision&)>& visit_;
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  bool inputKnown_ = false;
};

}  // namespace

Expected<DecisionLog> readDecisions(const std::string& log, const Span& span,
                                    const std::function<void(const Decision&)>& visit) {
  auto reader = LogReader::open(log);
  if (!reader) return Error{reader.error()};
  Reading reading(span, visit);
  LogMessage message;
  while (reader->next(message)) {
    const Status taken = reading.take(message);
    if (!taken) return Error{log + ": " + taken.error()};
  }
  if (!reader->status()) return Error{reader->status().error()};
  cli::tellNotes(*reader);
  if (const std::string lacks = reader->lacks(); !lacks.empty())
    reading.found.lacks = log + ": " + lacks;
  if (reading.found.frames == 0) return Error{log + ": holds no frames with outputs"};
  return std::move(reading.found);
}

}  // namespace kelpie::match
