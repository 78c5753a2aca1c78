// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <chrono>
#include <memory>

#include "robot/agent/log/Replay.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Figures.h"
#include "tools/cli/JsonText.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/match/BenchMatch.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/options/Usage.h"

namespace kelpie::cli {
namespace {

struct BenchOptions {
  std::string log = "out/match.mcap";
  std::string json = "-";
  std::string pycode = defaultScripts();
  bool match = false;
  MatchBench plan;
};

// Frames whose image the log did not keep run without vision; as whole frames they do not count.
class StopWatch : public agent::StageObserver {
 public:
  void begin(agent::Stage stage) override {
    withVision_ = withVision_ || stage == agent::Stage::vision;
    stageStart_ = Clock::now();
  }
  void end(agent::Stage stage) override {
    stages_[static_cast<std::size_t>(stage)].push_back(since(stageStart_));
  }
  void beginFrame() override {
    withVision_ = false;
    frameStart_ = Clock::now();
  }
  void endFrame() override {
    if (withVision_) frames_.push_back(since(frameStart_));
  }

  Json figures() const {
    Json stages = Json::object();
    for (std::size_t i = 0; i < agent::kStageCount; ++i)
      stages[agent::kStageNames[i]] = summary(stages_[i]);
    return {{"frame", summary(frames_)}, {"stages", stages}, {"frames", frames_.size()}};
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }
  static Json summary(const std::vector<double>& times) {
    double sum = 0.0;
    for (const double t : times) sum += t;
    return {{"mean_ns", times.empty() ? 0.0 : sum / static_cast<double>(times.size())},
            {"median_ns", percentile(times, 0.5)},
            {"p99_ns", percentile(times, 0.99)},
            {"max_ns", percentile(times, 1.0)}};
  }

  Clock::time_point stageStart_;
  Clock::time_point frameStart_;
  bool withVision_ = false;
  std::array<std::vector<double>, agent::kStageCount> stages_;
  std::vector<double> frames_;
};

int benchWholeMatch(const BenchOptions& options) {
  if (!canWrite(options.json)) return fail(options.json + ": cannot be written", kExitBadInput);
  const auto speeds = benchMatch(options.plan);
  if (!speeds) return fail(speeds.error(), kExitMachine);
  const Json json{{"physics_one", speeds->physicsOfOne},
                  {"match", speeds->match},
                  {"robots", options.plan.robots},
                  {"seconds", options.plan.seconds}};
  if (!writeWhole(options.json, jsonText(json, 2) + "\n"))
    return fail(options.json + ": cannot be written", kExitBadInput);
  return kExitDone;
}

int bench(const BenchOptions& options) {
  if (options.match) return benchWholeMatch(options);
  StopWatch watch;
  agent::ReplayOptions request;
  request.scripts = options.pycode;
  if (sameFile(options.log, options.json))
    return fail(options.json + ": is the log itself", kExitBadInput);
  if (!canWrite(options.json)) return fail(options.json + ": cannot be written", kExitBadInput);
  const auto result = agent::replay(options.log, request, watch);
  if (!result) return fail(result.error(), kExitBadInput);
  if (!writeWhole(options.json, jsonText(watch.figures(), 2) + "\n"))
    return fail(options.json + ": cannot be written", kExitBadInput);
  if (!result->lacks.empty())
    return fail(options.log + ": " + result->lacks + "; measured on the rest", kExitBadInput);
  return kExitDone;
}

}  // namespace

void addBench(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "bench",
      "Nanoseconds of each stage over the frames of a log; or how fast matches are played");
  auto options = std::make_shared<BenchOptions>();
  command.option("LOG", options->log, "The log to run on").showDefault();
  command.option("--json", options->json, "File for the figures, - for standard output");
  command.option("--pycode", options->pycode, "Behaviours (default: pycode/)")
      .check(existingPath());
  command.flag("--match", options->match,
               "How many times faster than a clock: one walking physical robot on a core "
               "(physics_one), a match with cameras and agents on all (match)");
  command.option("--robots", options->plan.robots, "of that match")
      .check(integerInRange(1, 8))
      .showDefault();
  command.option("--seconds", options->plan.seconds, "of that match")
      .check(inRange(1.0, 1e5))
      .showDefault();
  command.option("--seed", options->plan.seed, "of that match").check(inRange(0.0, 1e6));
  command.flag("--physical,!--fast", options->plan.physical,
               "with bodies with masses (the default), or kinematic ones");
  command.callback([options, &code] { code = bench(*options); });
}

}  // namespace kelpie::cli
