// SPDX-License-Identifier: Apache-2.0
// --place, --ball and --throw: the same words for play and kelpie-world.
#pragma once

#include "tools/cli/CommandLine.h"
#include "tools/sim/Staging.h"

namespace kelpie::cli {

void addStagingOptions(CommandLine& command, sim::StagingWords& staging);

}  // namespace kelpie::cli
