// SPDX-License-Identifier: Apache-2.0
// What the value tells of matches, as JSON and as text for people: goals, shots, expected goals for
// and against; whose doing was worth what: by robot, and by the leaf of the decision tree that was
// played, where a robot's log is given. Sums of several matches name a team by its colour alone.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/Figures.h"
#include "tools/league/value/MatchValue.h"

namespace kelpie::value {

// `value` as red sees it; of each colour goals, shots, expected goals of its shots and of all play.
cli::Json jsonOf(const MatchFigures& figures);
std::string lineOf(const MatchFigures& figures);

struct Worth {
  double lasts = 0.0;   // s
  double gained = 0.0;  // value: probability to score within the horizon, less that to be scored on
  double won = 0.0;     // of it what was gained, without what was lost again
};

// Which leaf each robot played when, from its log.
class Leaves {
 public:
  // Error: the log cannot be read, or holds no decisions.
  Status read(const std::string& log);
  // Empty where no log tells it.
  std::string at(const Doing& doing) const;

 private:
  using Robot = std::pair<TeamColour, std::uint8_t>;
  std::map<Robot, std::map<double, std::string>> played_;  // by seconds, from when on
};

// By colour and robot, or the leaf's name.
using Worths = std::map<std::pair<TeamColour, std::string>, Worth>;

class Report {
 public:
  // `leaves` of that match.
  void add(const MatchFigures& figures, const Leaves& leaves);
  std::string text() const;

 private:
  int matches_ = 0;
  MatchFigures sum_;
  Worths robots_, leaves_;
};

}  // namespace kelpie::value
