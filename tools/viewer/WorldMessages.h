// SPDX-License-Identifier: Apache-2.0
// All that viewers get of the world: the field once, then where ball and robots really are, the
// score and what the referee calls. Robots of which no log tells the joints are drawn on straight
// legs.
#pragma once

#include <set>
#include <string>

#include "robot/body/FieldDescription.h"
#include "tools/sim/world/Truth.h"
#include "tools/viewer/MessageSink.h"

namespace kelpie::viewer {

class WorldMessages {
 public:
  WorldMessages(TimeUs start, MessageSink& sink) : start_(start), sink_(sink) {}

  // The first field counts: a match is played on one.
  void field(TimeUs time, const body::FieldDescription& field);
  bool fieldKnown() const { return fieldKnown_; }
  // Somebody else draws this one.
  void drawnElsewhere(const std::string& robot) { drawnElsewhere_.insert(robot); }
  // Whether the last truth had this one among its robots.
  bool isPlaced(const std::string& robot) const { return placed_.count(robot) > 0; }
  void truth(const sim::TruthFrame& truth);
  void event(const sim::MatchEvent& event);

 private:
  TimeUs at(TimeUs time) const { return {start_.us + time.us}; }
  void robots(TimeUs time, const sim::TruthFrame& truth);
  void ball(TimeUs time, const sim::TruthFrame& truth);

  TimeUs start_;
  MessageSink& sink_;
  bool fieldKnown_ = false;
  std::set<std::string> drawnElsewhere_;
  std::set<std::string> placed_;
};

}  // namespace kelpie::viewer
