// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "robot/core/parameters/ParameterFile.h"
#include "robot/host/OnCores.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/calibrate/GainPicture.h"
#include "tools/cli/options/Usage.h"
#include "tools/learn/walk/WalkFile.h"
#include "tools/learn/walk/WalkFit.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::cli {
namespace {

constexpr double kLearningStep = 0.004;  // s; as good as 0.002 for walks and half as dear
constexpr double kJudgingStep = 0.002;
constexpr int kJudges = 5;
constexpr std::uint64_t kJudgesFrom = 500000;  // seeds of models that no search has seen
constexpr int kSpeeds = 32;                    // on each model, for the calibration
constexpr int kCommands = 100;                 // on each model, for the odometry

constexpr const char* kHelp =
    R"(
Searches the numbers of one walk: stance, gait, and how far the feet may go in each direction. Each
trial walks on several varied models at once (friction, armature, contact, servo, mass, play of the
gears), in four directions and by random commands; what is fast on one model alone gains nothing.
Afterwards the set's speeds are measured and its calibration fitted, and it is judged on five models
that the search has not seen.

KIND is normal, fast, turning, dribble, back, low or weak. The search begins at that walk as it is,
or as the parameter file of --start has it; one that is good already gains by a --spread of 0.05.
With --journal a search that was broken off goes on.

  kelpie calibrate walk normal --out actuator/data/walks/normal.toml --journal walk.journal
  kelpie calibrate walk fast --trials 1000 --seed 2 --out fast.toml --picture gain.png
  kelpie play --params fast.toml)";

struct WalkOptions {
  std::string kind;
  std::string out;
  std::string start;
  std::string picture;
  int models = 4;
  bool onlyFit = false;
  bool keepStance = false;
  learn::SearchPlan plan{600, 0, 0.2, 1, {}, {}};
};

Expected<WalkKind> kindOf(const std::string& name) {
  for (std::uint8_t i = 0; i < kWalkKindCount; ++i)
    if (name == learn::nameOf(static_cast<WalkKind>(i))) return static_cast<WalkKind>(i);
  return Error{name + ": no such walk; normal, fast, turning, dribble, back, low and weak are"};
}

Expected<actuator::WalkSet> startOf(const WalkOptions& options, WalkKind kind) {
  actuator::ActuatorParams params;
  if (!options.start.empty()) {
    ParameterSet set;
    set.add("actuator", params);
    const Status read = set.overlay(options.start);
    if (!read) return Error{read.error()};
  }
  return actuator::walkSet(params.walks, kind);
}

learn::WalkTrialPlan planOf(WalkKind kind) {
  learn::WalkTrialPlan plan;
  plan.kind = kind;
  return plan;
}

// The speeds that behaviours ask for can be walked only when a first calibration is there.
void calibrated(WalkKind kind, std::uint64_t seed, int models, actuator::WalkSet& set) {
  const auto varied = learn::variedModels(seed, models, kJudgingStep);
  learn::WalkSamples samples;
  set.calibration = {};
  for (const std::uint64_t again : {seed, seed + 1000}) {
    std::vector<learn::WalkSamples> each(varied.size());
    host::onCores(varied.size(), [&](std::size_t i) {
      each[i] = learn::sampleWalk(kind, set, varied[i], kSpeeds, again + i);
    });
    for (const auto& more : each) learn::append(more, samples);
    set.calibration = learn::fitCalibration(samples.speeds);
  }
  set.freeLoad = learn::fitFreeLoad(samples.speeds);
  std::vector<std::vector<learn::PathSample>> ways(varied.size());
  host::onCores(varied.size(), [&](std::size_t i) {
    ways[i] = learn::samplePaths(kind, set, varied[i], kCommands, seed + i);
  });
  for (std::size_t i = 1; i < ways.size(); ++i)
    ways[0].insert(ways[0].end(), ways[i].begin(), ways[i].end());
  set.odometry = learn::fitOdometry(ways[0]);
  set.oscillation = learn::fitOscillation(samples.oscillations, set.odometry, set.max);
}

// Of five models: the mean and the slowest.
std::string judged(WalkKind kind, const actuator::WalkSet& set) {
  learn::WalkTrialPlan plan = planOf(kind);
  plan.measuredSeconds = 4.0;
  plan.randomSeconds = 60.0;
  const auto models = learn::variedModels(kJudgesFrom, kJudges, kJudgingStep);
  const auto trials = learn::tryOnAll(plan, set, models, kJudgesFrom);
  std::array<double, learn::kWalkDirections> mean{};
  std::array<double, learn::kWalkDirections> min{};
  int falls = 0;
  for (std::size_t way = 0; way < learn::kWalkDirections; ++way) {
    min[way] = trials[0].speed[way];
    for (const auto& trial : trials) {
      mean[way] += trial.speed[way] / kJudges;
      min[way] = std::min(min[way], trial.speed[way]);
    }
  }
  double lost = 0.0;
  for (const auto& trial : trials) {
    falls += trial.fell ? 1 : 0;
    lost += trial.lost / kJudges;
  }
  const double deg = Angle::rad(1.0).deg();
  return fmt::format(
      "forward {:.1f} (slowest {:.1f}), back {:.1f} ({:.1f}), side {:.1f} ({:.1f}) cm/s, turn "
      "{:.0f} "
      "({:.0f}) deg/s; {} of {} fell within a minute{}",
      mean[0], min[0], mean[1], min[1], mean[2], min[2], deg * mean[3], deg * min[3], falls,
      kJudges,
      kind == WalkKind::dribble ? fmt::format("; ball lost in {:.0f} %", 100.0 * lost) : "");
}

Expected<actuator::WalkSet> learnt(const WalkOptions& options, WalkKind kind,
                                   const actuator::WalkSet& start) {
  const std::uint64_t modelSeed = 1000 + 100 * std::uint64_t{options.plan.seed};
  const auto models = learn::variedModels(modelSeed, options.models, kLearningStep);
  const learn::WalkAim aim = learn::aimOf(kind);
  const auto part = options.keepStance ? learn::WalkPart::gait : learn::WalkPart::whole;
  const auto gain = [&](const std::vector<double>& point) {
    const auto set = learn::walkOf(point, part, start);
    return learn::gainOf(learn::tryOnAll(planOf(kind), set, models, modelSeed), aim);
  };
  Progress progress("walk " + options.kind, "trials");
  learn::SearchPlan plan = options.plan;
  plan.trial = fmt::format("walk {} models {}", options.kind, options.models);
  const auto all = static_cast<std::size_t>(plan.trials);
  const auto found =
      learn::search(learn::walkSpace(kind, part, start), plan, gain,
                    [&](int done, double) { progress(static_cast<std::size_t>(done), all); });
  if (!found) return Error{found.error()};
  fmt::print("gain {:.3f} after {} trials, {} of them from the journal\n", found->gain,
             found->gains.size(), found->replayed);
  if (!options.picture.empty()) {
    const Status drawn =
        drawGain(found->gains, "kelpie calibrate walk " + options.kind, options.picture);
    if (!drawn) return Error{drawn.error()};
  }
  return learn::walkOf(found->best, part, start);
}

int calibrateWalk(const WalkOptions& options) {
  const auto kind = kindOf(options.kind);
  if (!kind) return fail(kind.error(), kExitBadInput);
  if (!canWrite(options.out)) return fail(options.out + ": cannot be written", kExitBadInput);
  if (!options.picture.empty() && !canWrite(options.picture))
    return fail(options.picture + ": cannot be written", kExitBadInput);
  const auto start = startOf(options, *kind);
  if (!start) return fail(start.error(), kExitBadInput);
  fmt::print("before, on models that no search has seen: {}\n", judged(*kind, *start));
  Expected<actuator::WalkSet> set = *start;
  if (!options.onlyFit) set = learnt(options, *kind, *start);
  if (!set) return fail(set.error(), kExitBadInput);
  calibrated(*kind, 2000 + 100 * std::uint64_t{options.plan.seed}, options.models, *set);
  const std::string verdict = judged(*kind, *set);
  fmt::print("after: {}\n", verdict);
  const std::string how = options.onlyFit ? fmt::format("--fit --models {}", options.models)
                                          : fmt::format("--trials {}{}", options.plan.trials,
                                                        options.keepStance ? " --keep-stance" : "");
  const std::string heading = fmt::format("kelpie calibrate walk {} {} --seed {}\n{}", options.kind,
                                          how, options.plan.seed, verdict);
  if (!writeWhole(options.out, learn::walkText(*kind, *set, heading)))
    return fail(options.out + ": cannot be written", kExitBadInput);
  return kExitDone;
}

}  // namespace

void addCalibrateWalk(CommandLine& command, int& code) {
  auto walk = command.subcommand("walk", "Learn a walk on varied physical models");
  walk.footer(kHelp);
  auto options = std::make_shared<WalkOptions>();
  walk.option("KIND", options->kind, "the walk that is learnt").required();
  walk.option("--out", options->out, "parameter file to write").required();
  walk.option("--start", options->start, "parameter file that the search begins at");
  walk.option("--trials", options->plan.trials, "of the search")
      .check(inRange(1, 1000000))
      .showDefault();
  walk.option("--seed", options->plan.seed, "of search and models")
      .check(inRange(0, 1e6))
      .showDefault();
  walk.option("--spread", options->plan.spread,
              "where the search begins: a standard deviation, share of each number's range")
      .check(inRange(0.001, 1.0))
      .showDefault();
  walk.option("--models", options->models, "varied models to learn on")
      .check(inRange(1, 100))
      .showDefault();
  walk.option("--journal", options->plan.journal, "file of the trials; goes on where it ends");
  walk.option("--picture", options->picture, "PNG of the gain");
  walk.flag("--keep-stance", options->keepStance,
            "searches the gait alone: kicks begin in the stance");
  walk.flag("--fit", options->onlyFit, "calibrates the walk as it is, without a search");
  walk.callback([options, &code] { code = calibrateWalk(*options); });
}

}  // namespace kelpie::cli
