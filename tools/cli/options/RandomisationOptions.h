// SPDX-License-Identifier: Apache-2.0
// Which randomised world (tools/sim/bodies/Randomisation.h) a command line asks for; the same words
// for play, evaluate and kelpie-world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/cli/options/CommandLine.h"
#include "tools/sim/bodies/Randomisation.h"

namespace kelpie::cli {

struct RandomisationOptions {
  std::uint64_t seed = 0;         // 0: the nominal world
  std::vector<std::string> only;  // kinds; empty: all
  double tiltError = 0.0;         // deg, constant, of every robot, whatever the seed
  double rollError = 0.0;         // deg
};

// --randomise and --randomise-only.
void addRandomisationOptions(CommandLine& command, RandomisationOptions& options);
// --tilt-error and --roll-error.
void addLeanOptions(CommandLine& command, RandomisationOptions& options);

sim::RandomisationParams paramsOf(const RandomisationOptions& options);
// The words that ask kelpie-world for the same.
std::vector<std::string> wordsOf(const RandomisationOptions& options);

}  // namespace kelpie::cli
