// SPDX-License-Identifier: Apache-2.0
// The options of `kelpie play` for agents that are somebody else's programs (tools/session,
// Strangers.h).
#pragma once

#include <string>

#include "tools/cli/options/CommandLine.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

// After the options --red, --blue and --percepts, beside which they cannot stand.
void addStrangerOptions(CommandLine& command, SessionOptions& session);
// An error names an option that is given without a command.
Status checkStrangerOptions(const CommandLine& command, const SessionOptions& session);
// An error names a team with a command that nothing can start, or no robot that could obey it.
Status checkStrangers(const SessionOptions& session);
// What a team is called whose robots a command plays: "to_ball" of "python3 agent/to_ball.py".
std::string programIn(const std::string& command);

}  // namespace kelpie::cli
