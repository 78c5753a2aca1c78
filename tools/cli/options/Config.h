// SPDX-License-Identifier: Apache-2.0
// The options that make an agent's configuration, the same for kelpie-agent, import and replay.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/agent/AgentConfig.h"
#include "tools/cli/options/CommandLine.h"
#include "tools/cli/options/Usage.h"

namespace kelpie::cli {

// What the agent's body is: that of the config as it is (a log's, or one with masses), a kinematic
// one, or one with masses whose load tells that it is stuck.
enum class Body : std::uint8_t { asItIs, fast, physical };

struct ConfigOptions {
  std::string field;                // empty: as it is (2006 for a new one)
  std::string team;                 // red or blue; empty: as it is
  int player = 0;                   // 1 to 4; 0: as it is
  std::string colourTable;          // file
  std::string ring;                 // nominal, none, 2006 or a file
  std::string initial;              // "x,y,heading" in cm and degrees
  std::vector<std::string> params;  // TOML files, general to specific
  std::vector<std::string> set;     // "behaviour.task.grab=false": over what the files say
  Body body = Body::asItIs;
};

// Registers --field, --team, --colour-table, --ring, --init, --params and --set.
void addConfigOptions(CommandLine& command, ConfigOptions& options);

// The values of the parameter files that differ from the defaults, "gps.ball.gate" -> "5 (file:3)",
// and a hash of the whole set; for the log.
std::map<std::string, std::string> parameterNotes(const ConfigOptions& options);

// Changes `config` as asked. On an error (one line, file and place) it is left half changed.
Status applyConfig(const ConfigOptions& options, agent::AgentConfig& config);

// The default configuration: field 2006, red player 1, nominal colours and ring.
Expected<agent::AgentConfig> makeConfig(const ConfigOptions& options);
// The same with nominal colours and ring that are there already, as for each of several robots.
Expected<agent::AgentConfig> makeConfig(const ConfigOptions& options,
                                        const vision::VisionCalibration& nominal);

// A folder of behaviours must hold main.py; a zip is looked into when it is loaded.
Status checkScripts(const std::string& scripts);

// The behaviours that came with the program (DataFolder.h).
std::string defaultScripts();
// The folder of the team that plays where nobody names another.
std::string defaultTeam();

}  // namespace kelpie::cli
