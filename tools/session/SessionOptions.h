// SPDX-License-Identifier: Apache-2.0
// What is asked for when a match is played: field, robots, their parameters, and what is kept of
// it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/cli/log/Logs.h"
#include "tools/cli/options/RandomisationOptions.h"
#include "tools/sim/staging/Staging.h"

namespace kelpie::cli {

// Another robot of the match, mate or opponent; nobody hears what it believes. Field, body and the
// way of its images are the match's.
struct OtherRobot {
  std::string team = "blue";
  int player = 1;
  std::string pycode;               // as in SessionOptions
  std::vector<std::string> params;  // so
  std::vector<std::string> set;     // so
  std::uint64_t seed = 1;           // of its losses
};

// For `set`: of a match that nobody watches, which is judged by the behaviours it began with.
constexpr const char* kNoReload = "behaviour.reload=false";

struct SessionOptions {
  std::uint64_t seed = 1;
  double seconds = 60.0;
  int goals = 1;
  std::string field = "2006";
  std::string team = "red";      // of the robot that is watched,
  int player = 1;                // its number
  bool rules = false;            // a referee who knows more than goals and balls out,
  bool fromPlay = false;         // who lets play go on as it stands; `goals` end it
  double holdingDistance = 0.0;  // cm that a robot may carry the ball; 0: the field's
  std::string radio = "world";   // or udp, of this machine; none: all packets are lost
  double radioLoss = -1.0;       // share of packets; below 0: the world's
  double radioDelay = -1.0;      // s under way; so
  std::uint16_t controller = 0;  // UDP port of a game controller that rules the match; 0: none
  bool respawn = false;          // an agent that dies is started again, and plays on
  std::string scenario = "empty-goal";
  double dropRate = 0.0;
  std::string pycode;               // folder or zip; empty: the one of the source tree
  bool trust = false;               // scripts from elsewhere are not confined (Confinement.h)
  std::vector<std::string> params;  // TOML files, general to specific
  std::vector<std::string> set;     // "behaviour.task.grab=false", over the files
  std::string colourTable;          // file; empty: the built-in one
  std::string ring = "nominal";
  std::vector<std::string> artefactsOff;  // of kelpie-world's --no-...
  RandomisationOptions randomised;
  bool physical = true;   // bodies with masses and servos; otherwise kinematic ones
  bool percepts = false;  // no images: see PerceptSession.h
  // Where the joined log goes, in a folder of its own that has a `playing` (MatchFolder.h); empty:
  // none is kept.
  std::string log;
  bool endWithLog = false;               // a log that cannot be written (disk full) ends the match
  ImagesKept images = ImagesKept::some;  // of that log
  bool allLogs = false;   // beside it those of all other robots, with class planes: red-1.mcap
  bool realTime = false;  // no faster than a clock
  bool live = false;      // logs are written so that who watches reads each message at once
  bool orders = false;    // the world hears SessionTalk::orders, and agents wait while it stands
  std::string driver;     // socket of who drives the robot; empty: the behaviours play
  // Commands that start somebody else's program for each robot of the team in place of Kelpie's
  // agent (Strangers.h); empty: none.
  std::string redAgent, blueAgent;
  double agentLimit = 0.5;  // s of real time that it has for an answer
  double agentWait = 10.0;  // s until it must be there
  std::vector<OtherRobot> others;
  std::vector<std::string> notes;  // "red=kelpie", kept in the log: whose teams play
  sim::Staging staging;            // places and throws beside the scenario's
  bool keepFrames = false;  // without `log`: SessionTalk::frames receives frames without images
  bool keepAll = false;     // and of those of all other robots
  bool keepTruth = false;   // the same with the world's log alone; the agent's is no file then

  const std::string& strangerOf(const std::string& ofTeam) const {
    return ofTeam == "red" ? redAgent : blueAgent;
  }
  // Whether Kelpie plays the robot that is watched: otherwise nothing is known of what it believes.
  bool watchesKelpie() const { return strangerOf(team).empty(); }
  bool keepsLog() const { return !log.empty() || keepFrames; }
};

}  // namespace kelpie::cli
