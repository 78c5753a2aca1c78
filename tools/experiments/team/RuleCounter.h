// SPDX-License-Identifier: Apache-2.0
// How often rules were played, counted from the traces of Commands: a rule is known by the steps
// that say that it decides. Such a step is written as "module/branch" or "module/branch/reason",
// each of them whole or with a '*' for its end; "*" is every frame. A rule that holds in two frames
// one after the other was played once.
#pragma once

#include <string>
#include <vector>

#include "robot/core/fields/Fields.h"
#include "robot/core/types/Command.h"

namespace kelpie::experiments {

// One row of the theses' list, as thesis_rules.json has it.
struct Rule {
  std::string id;                  // is of the thesis of 2006, B-4.2 of that of 2004
  std::string rule;                // in a few words
  std::vector<std::string> steps;  // any of them
  std::string unplayed;            // why nobody plays it, of a row without steps
  std::string scene;               // that brings it about where a match may not

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("id", &Rule::id), field("rule", &Rule::rule),
                     field("steps", &Rule::steps), field("unplayed", &Rule::unplayed),
                     field("scene", &Rule::scene));
  }
};

struct Plays {
  int times = 0;
  int frames = 0;
};

class RuleCounter {
 public:
  explicit RuleCounter(const std::vector<Rule>& rules);

  // The next frames are another robot's.
  void beginRobot();
  void frame(const Trace& trace);

  // In the order of the rules.
  const std::vector<Plays>& plays() const { return plays_; }

 private:
  struct Wanted {
    std::string module, branch, reason;  // each may end in '*'
  };
  static Wanted wantedOf(const std::string& step);
  static bool holds(const Wanted& wanted, const Trace& trace);

  std::vector<std::vector<Wanted>> rules_;
  std::vector<Plays> plays_;
  std::vector<bool> held_;  // in the frame before
};

}  // namespace kelpie::experiments
