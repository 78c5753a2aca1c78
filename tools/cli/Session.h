// SPDX-License-Identifier: Apache-2.0
// One match in the simulated world: starts the world and one agent process, watches both, and
// collects the result and the logs. Leaves no socket and no half-written file behind.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kelpie::cli {

struct SessionOptions {
  std::uint64_t seed = 1;
  double seconds = 60.0;
  int goals = 1;
  std::string field = "2006";
  std::string team = "red";
  std::string scenario = "empty-goal";
  double dropRate = 0.0;
  std::string pycode;               // folder or zip; empty: the one of the source tree
  std::vector<std::string> params;  // TOML files, general to specific
  std::string colourTable;          // file; empty: the built-in one
  std::string ring = "2006";
  std::vector<std::string> artefactsOff;  // of ring, noise, shift, rolling, blur, spectators
  std::string log;                        // where the merged log goes; empty: none is kept
};

struct SessionResult {
  std::string trouble;    // one line: what died and when; empty when the match was played out
  bool badInput = false;  // the trouble is what was asked for
  bool logged = false;    // the log is in its place, of a whole match or of one cut short
  int goals = 0;
  int ownGoals = 0;
  int outs = 0;
  double firstGoal = -1.0;  // s; meaningful when goals > 0
  double seconds = 0.0;     // simulated
};

// Called with each status line of the agent (what the robot believes, in words).
using StatusLine = std::function<void(const std::string&)>;

// After trouble the log is still there up to the last whole frame.
SessionResult runSession(const SessionOptions& options, const StatusLine& status);

}  // namespace kelpie::cli
