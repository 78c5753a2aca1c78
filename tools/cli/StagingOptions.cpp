// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/StagingOptions.h"

namespace kelpie::cli {

void addStagingOptions(CLI::App& command, sim::StagingWords& staging) {
  command.add_option("--place", staging.places,
                     "A robot's place beside the scenario's: TEAM:PLAYER:X,Y,DEG of red's field");
  command.add_option("--ball", staging.ball, "Where the ball lies, or rolls: X,Y or X,Y,VX,VY");
  command.add_option("--throw", staging.throws,
                     "A ball put down later: T:X,Y,VX,VY, or with :TEAM:PLAYER behind it to that "
                     "robot's right and ahead of it");
}

}  // namespace kelpie::cli
