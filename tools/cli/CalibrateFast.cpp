// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "tools/cli/Calibrate.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Usage.h"
#include "tools/learn/FastFit.h"
#include "tools/learn/WalkLearner.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHelp =
    R"(
The kinematic world (--fast) has no masses: feet that stand carry the body. This measures the normal
walk at many speeds on varied physical models, lets the kinematic robot walk at the same ones, and
prints the GroundParams of tools/sim/RobotModel.h that make them alike, with what is left.

  kelpie calibrate fast --seed 3)";

// Percent of the physical way, of all samples that go somewhere.
double off(const std::vector<learn::SpeedSample>& samples,
           const std::vector<actuator::Velocity>& walked) {
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& real = samples[i].real;
    sum += std::hypot(walked[i].forward - real.forward, walked[i].left - real.left);
    all += std::hypot(real.forward, real.left);
  }
  return 100.0 * sum / all;
}

int calibrateFast(std::uint64_t seed, int models, int speeds) {
  const actuator::ActuatorParams params;
  std::vector<learn::SpeedSample> samples;
  for (const auto& model : learn::variedModels(seed, models, 0.002)) {
    const auto more = learn::sampleSpeeds(WalkKind::normal, params.walks.normal, model, speeds,
                                          seed + samples.size());
    samples.insert(samples.end(), more.begin(), more.end());
  }
  const auto before = learn::kinematicSpeeds(samples, sim::GroundParams::plain(), seed);
  const sim::GroundParams ground = learn::fitGround(samples, before);
  const auto after = learn::kinematicSpeeds(samples, ground, seed);
  fmt::print(
      "forward {:.3f} back {:.3f} left {:.3f} turn {:.3f} leftPerTurn {:.2f} turnPerLeft {:.4f}\n",
      ground.forward, ground.back, ground.left, ground.turn, ground.leftPerTurn,
      ground.turnPerLeft);
  fmt::print(
      "ways differ by {:.1f} % on plain ground, by {:.1f} % on this; {} speeds on {} models\n",
      off(samples, before), off(samples, after), samples.size(), models);
  return kExitDone;
}

struct FastOptions {
  std::uint64_t seed = 1;
  int models = 4;
  int speeds = 48;
};

}  // namespace

void addCalibrateFast(CLI::App& command, int& code) {
  auto* fast =
      command.add_subcommand("fast", "Fit the kinematic body's walk to the physical one's");
  fast->footer(kHelp);
  auto options = std::make_shared<FastOptions>();
  fast->add_option("--seed", options->seed, "of models and speeds")
      ->check(inRange(0, kLargestSeed))
      ->capture_default_str();
  fast->add_option("--models", options->models, "varied physical models")
      ->check(inRange(1, 100))
      ->capture_default_str();
  fast->add_option("--speeds", options->speeds, "on each model")
      ->check(inRange(8, 1000))
      ->capture_default_str();
  fast->callback(
      [options, &code] { code = calibrateFast(options->seed, options->models, options->speeds); });
}

}  // namespace kelpie::cli
