// SPDX-License-Identifier: Apache-2.0
// The processes of somebody else's agents, one for each robot of a team with such a command. None
// of them can end a match: what becomes of one is the world's to tell (tools/sim/world/Stranger.h).
// At the end of the match they are asked by the world to go, and killed with all that they have
// started when they do not.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/cli/Process.h"
#include "tools/session/SessionCommands.h"

namespace kelpie::cli {

class Strangers {
 public:
  // Starts them when the world listens for them, so that they need not try again and again. One
  // that cannot be started at all has no process.
  static Strangers start(const SessionOptions& options, const RunDirectory& runDirectory,
                         Process& world);

  // Tells which have ended in trouble, and with SessionOptions::respawn starts those again.
  void watch(const std::function<void(const std::string&)>& tell);
  // The match is over: two seconds to go by themselves.
  void end();

 private:
  struct One {
    std::string name;
    std::vector<std::string> command;
    std::optional<Process> process;
    int lives;
  };

  std::vector<One> all_;
  bool respawn_ = false;
};

}  // namespace kelpie::cli
