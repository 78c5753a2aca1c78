// SPDX-License-Identifier: Apache-2.0
// A match that somebody outside rules with a game controller. States, kick-off, clock, scores and
// penalties are what its newest packet says. The world carries them out: who is penalised is
// put off the field and comes back at the half-way line; the ball lies in the middle before a
// kick-off, and at set whoever stands where it may not is put elsewhere; a ball that goes out is
// put on the throw-in line; one in a goal stays there until the controller decides. An out that it
// tells of a ball still in play (one that goes nowhere) drops the ball as one. Assumes scenes of
// the same players, in the order of time.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "robot/net/GameControlData.h"
#include "tools/sim/rules/RuledMatch.h"

namespace kelpie::sim {

// The reason of an `out` that is not put back.
constexpr const char* kInGoal = "in a goal; the controller decides";

class ControlledMatch {
 public:
  explicit ControlledMatch(const body::FieldDescription& field);

  // What the controller has sent; it holds from the next step on.
  void hear(const net::GameControlData& control) { news_ = control; }
  Verdict step(const MatchScene& scene, Score& score);
  // The second half is finished; or the first, and the controller has fallen silent.
  bool finished() const { return finished_; }
  // What every robot hears: all states are initial until the controller is heard.
  const net::GameControlData& control() const { return control_; }
  std::vector<MatchEvent> takeEvents();

 private:
  void record(EventKind kind, TeamColour team, const char* reason);
  void record(EventKind kind, std::size_t player, const char* reason);
  void putBall(Point2<Field> place);
  void carry(std::size_t player, const Pose2& place) {
    verdict_.carries.push_back({player, place});
  }
  void follow(Score& score);
  void followScore(TeamColour team, int scored, Score& score);
  void followState(const net::GameControlData& before);
  void followPenalties();
  void followDropIn(const net::GameControlData& before);
  void takePlaces();
  void watchBall(Score& score);
  void keepOffField();
  void judgeEnd(bool heard);

  body::FieldDescription field_;
  net::GameControlData control_;
  std::optional<net::GameControlData> news_;
  std::array<bool, kMaxRobots> offField_{};  // for a penalty
  TouchState touch_;
  bool inGoal_ = false;            // the ball, and the controller has not decided yet
  std::optional<TimeUs> putBack_;  // when the world did so last with a ball that was out
  TimeUs heard_;                   // from the controller
  bool started_ = false;
  bool finished_ = false;
  MatchScene scene_;
  Verdict verdict_;
  std::vector<MatchEvent> events_;
};

}  // namespace kelpie::sim
