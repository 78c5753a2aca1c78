// SPDX-License-Identifier: Apache-2.0
// Goals, balls out and the end of the match. A ball that leaves the field is put back at the
// throw-in place of the field's rules; after a goal it lies in the middle. Robots are not moved. No
// fouls.
#pragma once

#include <optional>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/sim/Ball.h"
#include "tools/sim/Truth.h"

namespace kelpie::sim {

struct RefereeParams {
  double seconds = 60.0;  // length of the match
  int goals = 1;          // of either team that end it; 0 = never

  static constexpr auto fields() {
    using P = RefereeParams;
    return fieldList(field("seconds", &P::seconds, "s", 0, 1e5),
                     field("goals", &P::goals, "", 0, 100));
  }
};

struct Goal {
  TeamColour team = TeamColour::red;  // that scored
  double time = 0.0;                  // s
};

struct Score {
  int red = 0;   // balls in the blue goal, y = length
  int blue = 0;  // balls in the yellow goal, y = 0
  int outs = 0;
  std::vector<Goal> goals;  // in their order
};

// The whole ball is behind a goal line and between the posts: which team scores.
std::optional<TeamColour> goalFor(const body::FieldDescription& field, Point2<Field> ball);
// The whole ball is beyond a line and not in a goal.
bool ballOut(const body::FieldDescription& field, Point2<Field> ball);

class Referee {
 public:
  Referee(const RefereeParams& params, const body::FieldDescription& field);

  // Whether it put the ball elsewhere.
  bool tick(TimeUs now, Ball& ball);
  bool finished() const { return finished_; }
  const Score& score() const { return score_; }
  std::vector<MatchEvent> takeEvents();

 private:
  void record(TimeUs now, EventKind kind, TeamColour team, Point2<Field> ball);

  RefereeParams params_;
  body::FieldDescription field_;
  Score score_;
  bool started_ = false;
  bool finished_ = false;
  std::vector<MatchEvent> events_;
};

}  // namespace kelpie::sim
