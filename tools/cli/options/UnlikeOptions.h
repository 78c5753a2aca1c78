// SPDX-License-Identifier: Apache-2.0
// Which unlike world (tools/sim/bodies/Unlike.h) a command line asks for; the same words for play,
// evaluate and kelpie-world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/cli/options/CommandLine.h"
#include "tools/sim/bodies/Unlike.h"

namespace kelpie::cli {

struct UnlikeOptions {
  std::uint64_t seed = 0;         // 0: the like world
  std::vector<std::string> only;  // kinds; empty: all
  double tiltError = 0.0;         // deg, constant, of every robot, whatever the seed
  double rollError = 0.0;         // deg
};

// --unlike and --unlike-only.
void addUnlikeOptions(CommandLine& command, UnlikeOptions& options);
// --tilt-error and --roll-error.
void addLeanOptions(CommandLine& command, UnlikeOptions& options);

sim::UnlikeParams paramsOf(const UnlikeOptions& options);
// The words that ask kelpie-world for the same.
std::vector<std::string> wordsOf(const UnlikeOptions& options);

}  // namespace kelpie::cli
