// SPDX-License-Identifier: Apache-2.0
// The command lines of the processes of a match.
#pragma once

#include "tools/cli/Workshop.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

std::vector<std::string> worldCommand(const SessionOptions& options, const Workshop& workshop);
// Of the robot that is watched.
std::vector<std::string> agentCommand(const SessionOptions& options, const Workshop& workshop);
std::vector<std::string> otherCommand(const SessionOptions& options, const OtherRobot& robot,
                                      const Workshop& workshop);

}  // namespace kelpie::cli
