// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/RandomisationOptions.h"

#include "tools/cli/options/Usage.h"

namespace kelpie::cli {
namespace {

constexpr double kLargestLean = 20.0;  // deg

}  // namespace

void addRandomisationOptions(CommandLine& command, RandomisationOptions& options) {
  const auto seed =
      command
          .option("--randomise,--unlike", options.seed,
                  "Seed of a world that differs from the one that Kelpie was tuned in; 0: none")
          .check(inRange(0.0, kLargestSeed));
  command
      .option("--randomise-only,--unlike-only", options.only,
              "Only these kinds of difference (with --randomise; default: all)")
      .check(oneOf(sim::randomisedKinds()))
      .needs(seed);
}

void addLeanOptions(CommandLine& command, RandomisationOptions& options) {
  const auto lean = [&](const char* name, double& value, const char* what) {
    command.option(name, value, what).check(inRange(-kLargestLean, kLargestLean));
  };
  lean("--tilt-error", options.tiltError, "Degrees that every body's nose is lower than it knows");
  lean("--roll-error", options.rollError, "The same for its left side, higher than it knows");
}

sim::RandomisationParams paramsOf(const RandomisationOptions& options) {
  sim::RandomisationParams params = sim::randomisationParams(options.seed, options.only);
  params.lean = {Angle::deg(options.tiltError), Angle::deg(options.rollError)};
  return params;
}

std::vector<std::string> wordsOf(const RandomisationOptions& options) {
  std::vector<std::string> words;
  const auto add = [&words](const char* name, const std::string& value) {
    words.emplace_back(name);
    words.push_back(value);
  };
  if (options.seed != 0) add("--randomise", std::to_string(options.seed));
  if (options.seed != 0)
    for (const std::string& kind : options.only) add("--randomise-only", kind);
  if (options.tiltError != 0.0) add("--tilt-error", std::to_string(options.tiltError));
  if (options.rollError != 0.0) add("--roll-error", std::to_string(options.rollError));
  return words;
}

}  // namespace kelpie::cli
