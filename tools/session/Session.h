// SPDX-License-Identifier: Apache-2.0
// One match in the simulated world: starts the world and an agent process for each robot, watches
// them, and collects the result and the logs. The first robot is the one that is logged and
// watched. Leaves no socket and no half-written file behind.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

struct SessionResult {
  std::string trouble;     // one line: what died and when; empty when the match was played out
  bool badInput = false;   // the trouble is what was asked for
  bool logged = false;     // the log is in its place, of a whole match or of one cut short
  std::string logTrouble;  // one line: which log ended when, or was not joined; empty: none
  std::vector<std::string> logs;          // all that are in their place
  bool interrupted = false;               // by the user; the rest tells what was played until then
  std::vector<double> goals;              // s
  std::vector<double> ownGoals;           // s
  int redOwnGoals = 0, blueOwnGoals = 0;  // of all those what a team shot into its own goal
  int outs = 0;
  double seconds = 0.0;  // simulated
};

// How far a match by the rules is.
struct MatchTime {
  double seconds = 0.0;  // simulated
  std::string state;     // initial, ready, set, playing, finished
  bool firstHalf = true;
  double left = 0.0;  // s of play in this half
  int red = 0, blue = 0;
};

// Called with each status line of the agent (what the robot believes, in words), with each goal as
// it falls, and with any other line for the user (an error in a script), which goes to standard
// error without it. `time` is called twice a simulated second of a match by the rules. `over` is
// asked again and again: true ends the match. `frames` is called once after a match with
// keepFrames or keepTruth: the agent's log without images and the world's, both gone afterwards.
// Each may be empty.
struct SessionTalk {
  std::function<void(const std::string&)> status;
  std::function<void(const std::string&)> line;
  std::function<void(bool own, double seconds)> goal;
  std::function<void(const MatchTime&)> time;
  std::function<bool()> over;
  // The next order of a person who watches, as a line of tools/sim/staging/LiveOrder.h; empty:
  // none. Asked again and again.
  std::function<std::string()> orders;
  std::function<Status()> logs;  // before logs are joined into their places
  std::function<void(const std::string& agentLog, const std::string& worldLog)> frames;
  // So with keepAll: the logs of all robots.
  std::function<void(const std::vector<std::string>& logs, const std::string& worldLog)> all;
};

// After trouble the log is still there up to the last whole frame.
SessionResult runSession(const SessionOptions& options, const SessionTalk& talk);

}  // namespace kelpie::cli
