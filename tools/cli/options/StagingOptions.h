// SPDX-License-Identifier: Apache-2.0
// What several programs ask in the same words: --field and --team for play and teleop, --rules for
// play and league, --place, --ball and --throw for play and kelpie-world.
#pragma once

#include <string>

#include "tools/cli/options/CommandLine.h"
#include "tools/sim/staging/Staging.h"

namespace kelpie::cli {

void addSideOptions(CommandLine& command, std::string& field, std::string& team);
void addRulesOption(CommandLine& command, std::string& rules);
void addStagingOptions(CommandLine& command, sim::StagingWords& staging);

}  // namespace kelpie::cli
