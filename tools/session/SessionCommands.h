// SPDX-License-Identifier: Apache-2.0
// The command lines of the processes of a match.
#pragma once

#include "tools/cli/RunDirectory.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

std::vector<std::string> worldCommand(const SessionOptions& options,
                                      const RunDirectory& runDirectory);
// What of it does not depend on how its agents come by.
void addMatch(const SessionOptions& options, const RunDirectory& runDirectory,
              std::vector<std::string>& argv);
// Of somebody else's program (examples/agent/README.md), and the socket that it comes to.
std::vector<std::string> strangerCommand(const SessionOptions& options,
                                         const host::AgentHello& robot,
                                         const RunDirectory& runDirectory);
std::string strangerSocket(const host::AgentHello& robot, const RunDirectory& runDirectory);
// The robots of a session that such programs play.
std::vector<host::AgentHello> strangersOf(const SessionOptions& options);
// Whether who runs these scripts is confined: they did not come with Kelpie, and nobody trusts
// them.
bool isConfined(const SessionOptions& options, const std::string& scripts);
// Of the robot that is watched.
std::vector<std::string> agentCommand(const SessionOptions& options,
                                      const RunDirectory& runDirectory, int life = 0);
// Each of its lives, of which respawned agents have several, has a log of its own.
std::string agentLog(const SessionOptions& options, const RunDirectory& runDirectory, int life);
// Where a process writes a log of that name: into FOLDER/playing of a log that is kept, else into
// the run directory.
std::string partPath(const SessionOptions& options, const RunDirectory& runDirectory,
                     const std::string& name);
// "red-1.mcap", "red-1-2.mcap" of its second life.
std::string logName(const std::string& team, int player, int life);
// That of another robot, with keepAll or allLogs; so.
std::string otherLog(const SessionOptions& options, const RunDirectory& runDirectory,
                     const OtherRobot& robot, int life = 0);
std::vector<std::string> otherCommand(const SessionOptions& options, const OtherRobot& robot,
                                      const RunDirectory& runDirectory, int life = 0);

}  // namespace kelpie::cli
