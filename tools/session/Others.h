// SPDX-License-Identifier: Apache-2.0
// The other robots of a match as processes: what they say is heard, and one that dies has a name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "behaviour/watch/HungExit.h"
#include "tools/cli/Process.h"
#include "tools/cli/RunDirectory.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

// An agent that dies at once, again and again, is not started for ever.
constexpr int kMaxLives = 20;

class Others {
 public:
  // Starts them all, or none.
  static Expected<Others> start(const SessionOptions& options, const RunDirectory& runDirectory);

  // Takes what they have printed; a script's error goes to the user with the robot's name.
  void hear(const std::function<void(const std::string&)>& tell);
  // One of them has ended in trouble.
  bool failed();
  // "the opponent blue 1 died (signal 9)" or its complaint; empty when none failed.
  const std::string& trouble() const { return trouble_; }
  bool badInput() const { return code_ == 2; }
  bool gaveUp() const { return code_ == 1; }  // as it does when the world is gone
  bool hung() const { return code_ == behaviour::kHungExit; }
  void kill();
  // Starts the one in trouble again; false when it cannot be, or has died too often.
  bool revive();

 private:
  struct One {
    std::string name;
    std::function<std::vector<std::string>(int life)> command;  // each life has a log of its own
    std::optional<Process> process;
    std::string complaint;
    std::string last;  // of the other lines
    int lives = kMaxLives;
  };
  std::string endOf(const One& one);
  void hearOne(One& one, const std::function<void(const std::string&)>& tell);

  std::vector<One> all_;
  One* failed_ = nullptr;                // whose trouble it is
  std::vector<std::string> unreported_;  // what it said last
  std::string trouble_;
  int code_ = 0;  // of the one in trouble
};

}  // namespace kelpie::cli
