// SPDX-License-Identifier: Apache-2.0
// What the programs' command lines have in common: numbers that are checked, and one line for
// whoever mistypes.
#pragma once

#include <string>

#include "tools/cli/CommandLine.h"

namespace kelpie::cli {

// A number in [min, max]; unlike CLI::Range it refuses what is not a number, "nan" included.
CLI::Validator inRange(double min, double max);
// A word that says something.
CLI::Validator notEmpty();
constexpr double kLargestSeed = 9e15;  // every whole number up to here is a double

// Adds --version and parses; whatever is wrong becomes "NAME: what; `NAME --help` tells more" on
// standard error, and names the word that is not known. With `done` set the program ends with the
// code given: 0 after help or version, 2 for a usage error.
int parseOptions(CLI::App& app, int argc, char** argv, bool& done);

}  // namespace kelpie::cli
