// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/StagingOptions.h"

namespace kelpie::cli {

void addSideOptions(CommandLine& command, std::string& field, std::string& team) {
  command.option("--field", field, "2006, osaka2005 or 2004")
      .check(oneOf({"2006", "osaka2005", "2004"}))
      .showDefault();
  command.option("--team", team, "red attacks the blue goal")
      .check(oneOf({"red", "blue"}))
      .showDefault();
}

void addRulesOption(CommandLine& command, std::string& rules) {
  command
      .option("--rules", rules,
              "Of holding the ball: 2006 (3 s and 50 cm) or 2005 (3 s), for referee and "
              "behaviours alike")
      .check(oneOf({"2005", "2006"}))
      .showDefault();
}

void addStagingOptions(CommandLine& command, sim::StagingWords& staging) {
  command.option("--place", staging.places,
                 "A robot's place beside the scenario's: TEAM:PLAYER:X,Y,DEG of red's field");
  command.option("--ball", staging.ball, "Where the ball lies, or rolls: X,Y or X,Y,VX,VY");
  command.option("--throw", staging.throws,
                 "A ball put down later: T:X,Y,VX,VY, or with :TEAM:PLAYER behind it to that "
                 "robot's right and ahead of it");
  command.option("--take-ball", staging.takes,
                 "Somebody takes the ball away at T s and brings it back: T, T:SECONDS (else 5) "
                 "or T:SECONDS:X,Y (else to the middle)");
  command.option("--carry", staging.carries,
                 "Somebody carries a robot elsewhere at T s: T:TEAM:PLAYER:X,Y,DEG; as soon as "
                 "that place is free");
  command.option("--deaf", staging.deaf,
                 "A robot whose radio sends and does not receive: TEAM:PLAYER");
}

}  // namespace kelpie::cli
