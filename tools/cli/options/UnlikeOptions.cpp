// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/UnlikeOptions.h"

#include "tools/cli/options/Usage.h"

namespace kelpie::cli {
namespace {

constexpr double kLargestLean = 20.0;  // deg

}  // namespace

void addUnlikeOptions(CommandLine& command, UnlikeOptions& options) {
  const auto seed = command
                        .option("--unlike", options.seed,
                                "Seed of a world unlike the one that Kelpie was tuned in; 0: like")
                        .check(inRange(0.0, kLargestSeed));
  command
      .option("--unlike-only", options.only,
              "Only these kinds of difference (with --unlike; default: all)")
      .check(oneOf(sim::unlikeKinds()))
      .needs(seed);
}

void addLeanOptions(CommandLine& command, UnlikeOptions& options) {
  const auto lean = [&](const char* name, double& value, const char* what) {
    command.option(name, value, what).check(inRange(-kLargestLean, kLargestLean));
  };
  lean("--tilt-error", options.tiltError, "Degrees that every body's nose is lower than it knows");
  lean("--roll-error", options.rollError, "The same for its left side, higher than it knows");
}

sim::UnlikeParams paramsOf(const UnlikeOptions& options) {
  sim::UnlikeParams params = sim::unlikeParams(options.seed, options.only);
  params.lean = {Angle::deg(options.tiltError), Angle::deg(options.rollError)};
  return params;
}

std::vector<std::string> wordsOf(const UnlikeOptions& options) {
  std::vector<std::string> words;
  const auto add = [&words](const char* name, const std::string& value) {
    words.emplace_back(name);
    words.push_back(value);
  };
  if (options.seed != 0) add("--unlike", std::to_string(options.seed));
  if (options.seed != 0)
    for (const std::string& kind : options.only) add("--unlike-only", kind);
  if (options.tiltError != 0.0) add("--tilt-error", std::to_string(options.tiltError));
  if (options.rollError != 0.0) add("--roll-error", std::to_string(options.rollError));
  return words;
}

}  // namespace kelpie::cli
