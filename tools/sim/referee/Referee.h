// SPDX-License-Identifier: Apache-2.0
// Who calls in a match. Without `rules`: goals, balls out and the end of the match; a ball that
// leaves the field is put back at the throw-in place of the field's rules, after a goal it lies in
// the middle, robots are not moved, and there are no fouls. With them a whole match by the rules of
// the field description (rules/RuledMatch.h); `controlled`, by what a game controller outside says
// (ControlledMatch.h).
#pragma once

#include <optional>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/sim/referee/ControlledMatch.h"
#include "tools/sim/rules/RuledMatch.h"
#include "tools/sim/rules/ThrowIn.h"
#include "tools/sim/world/Ball.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::sim {

struct RefereeParams {
  double seconds = 60.0;  // length of the match; with rules it is two of body::Rules::halfTime
  int goals = 1;          // of either team that end it; 0 = never; with rules they do not
  bool rules = false;
  bool fromPlay = false;                 // with rules: one half without its kick-off; goals end it
  bool controlled = false;               // from outside; `rules` are not asked then
  TeamColour kickOff = TeamColour::red;  // of the first half; with rules only

  template <int = 0>
  static constexpr auto fields() {
    using P = RefereeParams;
    return fieldList(field("seconds", &P::seconds, "s", 0, 1e5),
                     field("goals", &P::goals, "", 0, 100), field("rules", &P::rules),
                     field("fromPlay", &P::fromPlay), field("controlled", &P::controlled),
                     field("kickOff", &P::kickOff, "", 0, 1));
  }
};

class Referee {
 public:
  Referee(const RefereeParams& params, const body::FieldDescription& field);

  // What is to be moved after a tick of the world, by the rules or without.
  Verdict judge(const MatchScene& scene);
  // Without rules: whether it put the ball elsewhere.
  bool tick(TimeUs now, Ball& ball);
  // What a game controller outside says; nothing comes of it unless it rules.
  void hear(const net::GameControlData& control);
  bool finished() const { return finished_; }
  // What is broadcast of the match, whoever rules it.
  net::GameControlData control() const;
  const Score& score() const { return score_; }
  std::vector<MatchEvent> takeEvents();

 private:
  void record(TimeUs now, EventKind kind, TeamColour team, Point2<Field> ball);

  RefereeParams params_;
  body::FieldDescription field_;
  std::optional<RuledMatch> ruled_;
  std::optional<ControlledMatch> controlled_;
  Score score_;
  bool started_ = false;
  bool finished_ = false;
  std::vector<MatchEvent> events_;
};

}  // namespace kelpie::sim
