// SPDX-License-Identifier: Apache-2.0
// Logs of an agent: writing one while it plays, and joining it with the world's.
#pragma once

#include <string>
#include <vector>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/LogSink.h"
#include "robot/agent/LoggedTypes.h"
#include "robot/core/LogReader.h"
#include "robot/core/LogWriter.h"

namespace kelpie::cli {

// Writes each input and output as it passes. Its first error stays in status().
class LogFile : public agent::LogSink {
 public:
  static Expected<LogFile> create(const std::string& path, const agent::AgentConfig& config,
                                  const LogMap& parameterNotes);

  void motion(const MotionInput& input, const MotionOutput& output) override;
  void frame(const FrameInput& input, const FrameOutput& output) override;
  Status close() { return writer_.close(); }

 private:
  explicit LogFile(LogWriter writer) : writer_(std::move(writer)) {}
  LogWriter writer_;
};

// Copies a message of a topic that we know, leaves out any other.
Status copyMessage(const LogMessage& message, LogWriter& out);

// Joins logs by time, with their metadata, into `out`, written whole or not at all; what a cut-off
// log still holds is taken.
Status mergeLogs(const std::vector<std::string>& logs, const std::string& out);

}  // namespace kelpie::cli
