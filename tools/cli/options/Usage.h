// SPDX-License-Identifier: Apache-2.0
// What the programs' command lines have in common: the largest seed, and one line for whoever
// mistypes.
#pragma once

#include "tools/cli/options/CommandLine.h"

namespace kelpie::cli {

constexpr double kLargestSeed = 9e15;  // every whole number up to here is a double

// Adds --version and parses; whatever is wrong becomes "NAME: what; `NAME --help` tells more" on
// standard error, and names the word that is not known. With `done` set the program ends with the
// code given: 0 after help or version, 2 for a usage error.
int parseOptions(CommandLine& line, int argc, char** argv, bool& done);

}  // namespace kelpie::cli
