// SPDX-License-Identifier: Apache-2.0
// One log's messages, taken one by one and sent on as those for viewers. A frame is sent when its
// output comes; what is damaged or out of its range is left out and counted.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogReader.h"
#include "tools/viewer/RobotMessages.h"
#include "tools/viewer/WorldMessages.h"

namespace kelpie::viewer {

// What the logs of one match have in common. The world's messages stand in each robot's log: of
// several logs that tell of the same time, the first counts.
class SharedWorld {
 public:
  SharedWorld(TimeUs start, MessageSink& sink) : start_(start), sink_(sink), world_(start, sink) {}

  TimeUs start() const { return start_; }
  MessageSink& sink() { return sink_; }
  WorldMessages& messages() { return world_; }
  // Whether a message of that topic and time is the log's to tell.
  bool isTold(const std::string& topic, TimeUs time, std::size_t log);
  // False: another log has told of this robot already.
  bool enter(const std::string& robot);

 private:
  struct Told {
    TimeUs time;
    std::size_t log;
  };
  TimeUs start_;
  MessageSink& sink_;
  WorldMessages world_;
  std::map<std::string, Told> told_;
  std::set<std::string> robots_;
};

class LogMessages {
 public:
  LogMessages(std::size_t number, SharedWorld& world) : number_(number), world_(world) {}

  // An error only where nothing of the log can be used: a second log of one robot.
  Status take(const LogMessage& message);
  std::size_t frames() const { return frames_; }
  std::size_t truths() const { return truths_; }
  std::size_t damaged() const { return damaged_; }

 private:
  Status configure(const LogMessage& message);
  bool takeInput(const LogMessage& message);
  bool takeOutput(const LogMessage& message);
  bool takeTruth(const LogMessage& message);
  bool takeEvent(const LogMessage& message);

  std::size_t number_;
  SharedWorld& world_;
  std::optional<RobotMessages> robot_;
  std::unique_ptr<PictureFrame> input_ = std::make_unique<PictureFrame>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  bool inputKnown_ = false;
  std::vector<std::uint8_t> jpeg_;
  std::size_t frames_ = 0;
  std::size_t truths_ = 0;
  std::size_t damaged_ = 0;
};

}  // namespace kelpie::viewer
