// SPDX-License-Identifier: Apache-2.0
// The options of a program that plays a match in a simulated world, and what it tells of it while
// it is played: kelpie-world, whose agents are processes, and kelpie-percepts, whose agents are
// inside it.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/log/LogWriter.h"
#include "tools/cli/options/RandomisationOptions.h"
#include "tools/cli/options/StagingOptions.h"
#include "tools/cli/options/Usage.h"
#include "tools/sim/staging/Staging.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {

struct WorldOptions {
  std::uint64_t seed = 1;
  std::string field = "2006";
  std::string scenario = "empty-goal";
  std::string truth;
  std::string result;
  std::vector<std::string> notes;  // KEY=VALUE
  bool tellGoals = false;
  bool tellTime = false;
  bool plainLog = false;
  bool noSlip = false;
  double holdingDistance = 0.0;  // cm; 0: the field's
  bool physical = true;
  cli::RandomisationOptions randomised;
  StagingWords staging;
  WorldParams world;
};

void addWorldOptions(cli::CommandLine& app, WorldOptions& options);
WorldParams worldParams(const WorldOptions& options);
// With the length of a half that the options say.
Expected<body::FieldDescription> fieldOf(const WorldOptions& options);
// The truth log, if one is asked for.
Status openLog(const WorldOptions& options, std::optional<LogWriter>& log);
// The file of the result, opened before the match by who cannot open files after it.
Status openResult(const WorldOptions& options, std::ofstream& file);
Status writeResult(const WorldOptions& options, const World& world, std::ofstream& file);

// A line on standard output, at once.
void tellLine(const std::string& line);
// Goals are reported as they fall: "goal red 19.633"; interventions are reported to the user, and
// who rules from outside hears of a ball that is in one.
void tell(const MatchEvent& event);

// Twice a simulated second: "time 12.5 playing 1 290 0 1" (tools/session reads it).
class TimeTeller {
 public:
  explicit TimeTeller(const World& world) : world_(&world) {}

  void operator()(TimeUs now);

 private:
  const World* world_;
  TimeUs next_;
};

}  // namespace kelpie::sim
