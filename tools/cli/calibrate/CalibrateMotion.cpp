// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/calibrate/GainPicture.h"
#include "tools/cli/options/Usage.h"
#include "tools/learn/kick/KickLearner.h"
#include "tools/learn/motion/BlockTrial.h"
#include "tools/learn/motion/GetUpTrial.h"
#include "tools/learn/motion/MotionFile.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::cli {
namespace {

constexpr double kStep = 0.002;  // s; shorter by itself while a ball touches the robot
constexpr int kJudges = 5;
constexpr int kJudgedPlaces = 12;
constexpr std::uint64_t kJudgesFrom = 500000;  // seeds of models and places that no search has seen

constexpr const char* kHelp =
    R"(
Searches the key frames of a motion: of each frame that gives angles its ticks, the legs and, if it
moves it, the head. Legs that are alike left and right stay so. Each trial is made on several varied
models. A kick shall send the ball far, its way within the aim's directions, from places some
millimetres apart; getting up shall end on the feet; a block shall cover much of the goal, soon, and
end in the stance. Afterwards it is judged on models and places
that the search has not seen.

The search begins at the motion as it is, or as the file of --start has it. With --journal a search
that was broken off goes on. docs/physical-body.md has the aims.

  kelpie calibrate motion hard_forward --out actuator/data/motions/hard_forward.toml
  kelpie calibrate motion upenn_left --trials 2000 --seed 2 --journal upenn.journal --out upenn.toml
  kelpie motion upenn.toml --film upenn.mp4)";

struct MotionOptions {
  std::string name;
  std::string out;
  std::string start;
  std::string picture;
  bool onlyFit = false;
  bool turned = false;
  int models = 4;
  int places = 3;
  double reach = 40.0;
  learn::SearchPlan plan{800, 0, 0.2, 1, {}, {}};
};

// What a motion is judged by; greater is better.
struct Judge {
  std::function<double(const actuator::MotionData&)> gain;
  // In words; of a kick also in the motion's own data.
  std::function<std::string(actuator::MotionData&)> verdict;
};

Judge judgeOfKick(const learn::KickAim& aim, const MotionOptions& options) {
  const std::uint64_t seed = 1000 + 100 * std::uint64_t{options.plan.seed};
  const auto before = options.turned ? learn::BeforeKick::turned : learn::BeforeKick::rests;
  const auto starts = std::make_shared<std::vector<learn::KickStart>>(learn::beforeKicks(
      aim, learn::variedModels(seed, options.models, kStep), options.places, seed, before));
  const auto unseen = std::make_shared<std::vector<learn::KickStart>>(learn::beforeKicks(
      aim, learn::variedModels(kJudgesFrom, kJudges, kStep), kJudgedPlaces, kJudgesFrom, before));
  return {[starts, aim](const actuator::MotionData& motion) {
            return learn::gainOf(learn::tryFromAll(motion, aim, *starts), aim, motion);
          },
          [unseen, aim](actuator::MotionData& motion) {
            const auto spread = learn::spreadOf(learn::tryFromAll(motion, aim, *unseen));
            const Point2<Robot> place = learn::meanPlace(*unseen);
            motion.kick = {place.y,           -place.x,         spread.distance,
                           spread.distanceSd, spread.direction, spread.directionSd};
            motion.way = spread.way;
            return learn::spreadText(spread, motion);
          }};
}

Judge judgeOfGettingUp(FallSide side, const MotionOptions& options) {
  const std::uint64_t seed = 1000 + 100 * std::uint64_t{options.plan.seed};
  const auto models = learn::variedModels(seed, options.models, kStep);
  const auto unseen = learn::variedModels(kJudgesFrom, 4 * kJudges, kStep);
  return {[=](const actuator::MotionData& motion) {
            return learn::getUpGain(motion, side, models, seed);
          },
          [=](actuator::MotionData& motion) {
            const double gain = learn::getUpGain(motion, side, unseen, kJudgesFrom);
            return fmt::format("{:.2f} of 2: 2 stands, 0 lies", gain);
          }};
}

Judge judgeOfBlock(MotionKind kind, const actuator::MotionData& start,
                   const MotionOptions& options) {
  const auto standing = [&](std::uint64_t seed, int models) {
    auto stages = std::make_shared<std::vector<learn::MotionStage>>();
    for (const sim::PhysicsParams& model : learn::variedModels(seed, models, kStep))
      stages->push_back(learn::standingStage(kind, start, model, seed));
    return stages;
  };
  const auto stages = standing(1000 + 100 * std::uint64_t{options.plan.seed}, options.models);
  const auto unseen = standing(kJudgesFrom, kJudges);
  return {
      [stages](const actuator::MotionData& motion) { return learn::blockGain(motion, *stages); },
      [unseen](actuator::MotionData& motion) {
        return fmt::format("{:.2f}: 1 covers 25 cm to each side that it is for",
                           learn::blockGain(motion, *unseen));
      }};
}

Expected<Judge> judgeOf(MotionKind kind, const actuator::MotionData& start,
                        const MotionOptions& options) {
  const auto* aim = learn::findKick(kind);
  if (options.turned && (aim == nullptr || !aim->held))
    return Error{"--turned: " + options.name + " is no kick of a held ball"};
  if (aim != nullptr) return judgeOfKick(learn::aimOf(*aim, start), options);
  for (const FallSide side : {FallSide::front, FallSide::back, FallSide::left, FallSide::right})
    if (learn::getUpMotion(side) == kind) return judgeOfGettingUp(side, options);
  if (learn::isBlock(kind)) return judgeOfBlock(kind, start, options);
  return Error{options.name +
               ": has no aim to be searched for; kicks, getting up, blocks have one" +
               (learn::mirrored(kind) != kind ? " (it is another's mirror image)" : "")};
}

Expected<actuator::MotionData> learnt(const MotionOptions& options, const Judge& judge,
                                      const actuator::MotionData& start) {
  const auto gain = [&](const std::vector<double>& point) {
    return judge.gain(learn::motionOf(point, start));
  };
  Progress progress("motion " + options.name, "trials");
  learn::SearchPlan plan = options.plan;
  plan.trial = fmt::format("motion {} models {} places {}{}", options.name, options.models,
                           options.places, options.turned ? " turned" : "");
  const auto all = static_cast<std::size_t>(plan.trials);
  const auto found =
      learn::search(learn::motionSpace(start, Angle::deg(options.reach)), plan, gain,
                    [&](int done, double) { progress(static_cast<std::size_t>(done), all); });
  if (!found) return Error{found.error()};
  fmt::print("gain {:.3f} after {} trials, {} of them from the journal\n", found->gain,
             found->gains.size(), found->replayed);
  if (!options.picture.empty()) {
    const Status drawn =
        drawGain(found->gains, "kelpie calibrate motion " + options.name, options.picture);
    if (!drawn) return Error{drawn.error()};
  }
  return learn::motionOf(found->best, start);
}

int calibrateMotion(const MotionOptions& options) {
  const auto kind = learn::motionNamed(options.name);
  if (!kind) return fail(kind.error(), kExitBadInput);
  if (!canWrite(options.out)) return fail(options.out + ": cannot be written", kExitBadInput);
  if (!options.picture.empty() && !canWrite(options.picture))
    return fail(options.picture + ": cannot be written", kExitBadInput);
  Expected<actuator::MotionData> motion = actuator::standardMotions()[*kind];
  if (!options.start.empty()) motion = learn::readMotion(options.start);
  if (!motion) return fail(motion.error(), kExitBadInput);
  const auto judge = judgeOf(*kind, *motion, options);
  if (!judge) return fail(judge.error(), kExitBadInput);
  fmt::print("before: {}\n", judge->verdict(*motion));
  if (!options.onlyFit) motion = learnt(options, *judge, *motion);
  if (!motion) return fail(motion.error(), kExitBadInput);
  const std::string verdict = judge->verdict(*motion);
  fmt::print("after: {}\n", verdict);
  const std::string about = fmt::format("kelpie calibrate motion {} --trials {} --seed {}{}\n{}",
                                        options.name, options.plan.trials, options.plan.seed,
                                        options.turned ? " --turned" : "", verdict);
  if (!writeWhole(options.out, learn::motionText(*motion, about, *kind)))
    return fail(options.out + ": cannot be written", kExitBadInput);
  return kExitDone;
}

}  // namespace

void addCalibrateMotion(CommandLine& command, int& code) {
  auto motion =
      command.subcommand("motion", "Search the key frames of a kick, a get-up or a block");
  motion.footer(kHelp);
  auto options = std::make_shared<MotionOptions>();
  motion.option("NAME", options->name, "the motion, hard_forward for example").required();
  motion.option("--out", options->out, "motion file to write").required();
  motion.option("--start", options->start, "motion file that the search begins at");
  motion.option("--trials", options->plan.trials, "of the search")
      .check(inRange(1, 1000000))
      .showDefault();
  motion.option("--seed", options->plan.seed, "of search, models and places")
      .check(inRange(0, 1e6))
      .showDefault();
  motion.option("--models", options->models, "varied models to learn on")
      .check(inRange(1, 100))
      .showDefault();
  motion.option("--places", options->places, "of the ball, on each model")
      .check(inRange(1, 100))
      .showDefault();
  motion.option("--reach", options->reach, "deg that an angle may go from where it starts")
      .check(inRange(0.1, 250))
      .showDefault();
  motion.option("--journal", options->plan.journal, "file of the trials; goes on where it ends");
  motion.flag("--turned", options->turned,
              "kicks of a held ball begin after a turn with it, as in matches");
  motion.flag("--fit", options->onlyFit,
              "judges the motion as it is, without a search, and writes what it does");
  motion.option("--picture", options->picture, "PNG of the gain");
  motion.callback([options, &code] { code = calibrateMotion(*options); });
}

}  // namespace kelpie::cli
