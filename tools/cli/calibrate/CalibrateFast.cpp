// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/options/Usage.h"
#include "tools/learn/walk/FastFit.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHelp =
    R"(
The kinematic world (--fast) has no masses: feet that stand carry the body. Walks are calibrated to
physical bodies (`kelpie calibrate walk`); this fits the GroundParams of
tools/sim/bodies/RobotModel.h so that the kinematic robot goes as fast as it is asked to, and prints
them with what is left. How far its balls go is in the motion files: `kelpie calibrate motion`.

  kelpie calibrate fast --seed 11)";

struct FastOptions {
  std::uint64_t seed = 1;
  int walks = 120;
};

int calibrateFast(const FastOptions& options) {
  const auto plain = learn::sampleFast(sim::GroundParams::plain(), options.walks, options.seed);
  const sim::GroundParams ground = learn::fitGround(plain);
  fmt::print("forward {:.3f} left {:.3f} turn {:.3f}\n", ground.forward, ground.left, ground.turn);
  const learn::FastError before = learn::errorOf(plain);
  const learn::FastError after =
      learn::errorOf(learn::sampleFast(ground, options.walks, options.seed + 1));
  fmt::print(
      "speed is off by {:.1f} % of the way, {:.1f} % of the turn on plain ground, by "
      "{:.1f} and {:.1f} % on this\n",
      before.way, before.turn, after.way, after.turn);
  return kExitDone;
}

}  // namespace

void addCalibrateFast(CommandLine& command, int& code) {
  auto fast = command.subcommand("fast", "Fit the kinematic body's walk to the physical one's");
  fast.footer(kHelp);
  auto options = std::make_shared<FastOptions>();
  fast.option("--seed", options->seed, "of walks and slips")
      .check(inRange(0, kLargestSeed))
      .showDefault();
  fast.option("--walks", options->walks, "even walks to fit to")
      .check(inRange(12, 100000))
      .showDefault();
  fast.callback([options, &code] { code = calibrateFast(*options); });
}

}  // namespace kelpie::cli
