// SPDX-License-Identifier: Apache-2.0
// What one robot saw and decided, from its log, at times that rise. Between two images the last one
// stays.
#pragma once

#include <memory>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/log/LogReader.h"
#include "tools/match/Draw.h"

namespace kelpie::broadcast {

class Feed {
 public:
  // An error where it is no log of a robot.
  static Expected<Feed> open(const std::string& path);

  TeamColour team() const { return team_; }
  int player() const { return player_; }
  // Reads on to the last frame until then.
  void advance(double seconds);
  bool any() const { return any_; }
  match::Moment moment() const { return {*input_, *output_, {}, fresh_}; }

 private:
  Feed(LogReader reader, TeamColour team, int player)
      : reader_(std::move(reader)), team_(team), player_(player) {}
  void step();

  LogReader reader_;
  TeamColour team_;
  int player_;
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  LogMessage message_;
  bool pending_ = false;  // the message is of a later time
  bool inputKnown_ = false;
  bool fresh_ = true;
  bool any_ = false;
};

}  // namespace kelpie::broadcast
