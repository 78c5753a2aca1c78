// SPDX-License-Identifier: Apache-2.0
// Two teams as the robots of one session: how many a side, and by whose behaviours. A team's folder
// holds behaviours (main.py), or parameters for them (team.toml), or both; what it does not hold
// is the source tree's. Number 1 of two or more keeps the goal.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

// For `set`: who keeps the goal.
constexpr const char* kKeeps = "behaviour.task.player=1";  // PlayerKind::goalie

struct TeamPlan {
  int red = 4;
  int blue = 4;
  std::string redFolder;   // empty: the source tree's behaviours
  std::string blueFolder;  // so
};

// "4v4": 0 to 4 a side, and somebody at all; an error says so.
Expected<TeamPlan> teamPlan(const std::string& robots);

// Makes them the robots of the session, by the rules from a kick-off. The one that is watched and
// logged is the first forward of `options.team`, or of the other one when that is empty or only
// that is Kelpie's. An error names a folder that holds neither behaviours nor parameters.
Status useTeams(const TeamPlan& plan, SessionOptions& options);

// Of which year the rules of holding are, for referee and behaviours alike, before useTeams(): 2006
// (3 s and 50 cm, the field's own) or 2005 (3 s, any way).
void useRules(const std::string& year, SessionOptions& options);

// Every robot of a session, the one that is watched first.
std::vector<host::AgentHello> robotsOf(const SessionOptions& options);

}  // namespace kelpie::cli
