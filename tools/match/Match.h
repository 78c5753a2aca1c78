// SPDX-License-Identifier: Apache-2.0
// A log of a match as moments: each frame's input and output with the true places of that time, all
// in the field frame of the robot's own team. Its own robot is the one of the world's whose team
// and player its configuration names.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "robot/core/log/LogReader.h"
#include "tools/match/Draw.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::match {

class Match {
 public:
  // An error when the file is no log, or holds no frames with outputs.
  static Expected<Match> open(const std::string& path);

  const body::FieldDescription& field() const { return field_; }
  TeamColour team() const { return team_; }
  std::uint8_t player() const { return player_; }
  std::size_t frames() const { return frames_; }
  // "LOG: cut off at byte N; ...", what of it could not be read; empty: nothing.
  const std::string& lacks() const { return lacks_; }
  // What whoever started the match wrote into the log of it: "seed", "red", "blue"; maybe nothing.
  const LogMap& notes() const { return notes_; }
  // What was called in it, in the order of time.
  const std::vector<sim::MatchEvent>& events() const { return events_; }
  // Until `show` answers false.
  void forEachMoment(const std::function<bool(const Moment&)>& show) const;

 private:
  void takeEvent(const LogMessage& message);

  std::string path_;
  body::FieldDescription field_;
  TeamColour team_ = TeamColour::red;
  std::uint8_t player_ = 1;
  std::size_t frames_ = 0;
  std::string lacks_;
  LogMap notes_;
  std::vector<sim::MatchEvent> events_;
};

}  // namespace kelpie::match
