// SPDX-License-Identifier: Apache-2.0
// One match in the simulated world: starts the world and an agent process for each robot, watches
// them, and collects the result and the logs. The first robot is the one that is logged and
// watched. Leaves no socket and no half-written file behind.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/cli/UnlikeOptions.h"
#include "tools/sim/Staging.h"

namespace kelpie::cli {

// Another robot of the match; nobody hears what it believes. Field, body and the way of its images
// are the match's.
struct Opponent {
  std::string team = "blue";
  int player = 1;
  std::string pycode;               // as in SessionOptions
  std::vector<std::string> params;  // so
  std::vector<std::string> set;     // so
  std::uint64_t seed = 1;           // of its losses
};

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
  std::vector<std::string> set;     // "behaviour.task.grab=false", over the files
  std::string colourTable;          // file; empty: the built-in one
  std::string ring = "nominal";
  std::vector<std::string> artefactsOff;  // of kelpie-world's --no-...
  UnlikeOptions unlike;
  bool physical = true;    // bodies with masses and servos; otherwise kinematic ones
  std::string log;         // where the merged log goes; empty: none is kept
  bool allImages = false;  // the log keeps every image (Logs.h)
  bool realTime = false;   // no faster than a clock
  std::string driver;      // socket of who drives the robot; empty: the behaviours play
  std::vector<Opponent> opponents;
  sim::Staging staging;     // places and throws beside the scenario's
  bool keepFrames = false;  // without `log`: SessionTalk::frames is told of frames without images

  bool keepsLog() const { return !log.empty() || keepFrames; }
};

struct SessionResult {
  std::string trouble;        // one line: what died and when; empty when the match was played out
  bool badInput = false;      // the trouble is what was asked for
  bool logged = false;        // the log is in its place, of a whole match or of one cut short
  bool interrupted = false;   // by the user; the rest tells what was played until then
  std::vector<double> goals;  // s
  std::vector<double> ownGoals;  // s
  int outs = 0;
  double seconds = 0.0;  // simulated
};

// Called with each status line of the agent (what the robot believes, in words), with each goal as
// it falls, and with any other line for the user (an error in a script), which goes to standard
// error without it. `over` is asked again and again: true ends the match. `frames` is called once
// after a match with keepFrames: the agent's log without images and the world's, both gone
// afterwards. Each may be empty.
struct SessionTalk {
  std::function<void(const std::string&)> status;
  std::function<void(const std::string&)> line;
  std::function<void(bool own, double seconds)> goal;
  std::function<bool()> over;
  std::function<void(const std::string& agentLog, const std::string& worldLog)> frames;
};

// After trouble the log is still there up to the last whole frame.
SessionResult runSession(const SessionOptions& options, const SessionTalk& talk);

}  // namespace kelpie::cli
