// SPDX-License-Identifier: Apache-2.0
// The search over the field by lines alone: robots at random places stand and look about until the
// search that was asked for has answered. Judged are the heaviest mode and any mode, a pose and its
// twin alike, within 20 cm and 10 deg (checklist M43); then landmarks are seen too for two seconds,
// and the twin no longer counts.
#include <vector>

#include "tools/experiments/Experiment.h"
#include "tools/experiments/LocaliseFilters.h"
#include "tools/experiments/StandingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kMaxFrames = 450;
constexpr int kLandmarkFrames = 60;
constexpr double kNearCm = 20.0;
constexpr double kNearDeg = 10.0;

struct Tally {
  int trials = 0;
  int answered = 0;
  int best = 0;
  int any = 0;
  int known = 0;
  std::vector<double> cm;       // of the best mode, if right
  std::vector<double> seconds;  // until the answer

  double rate(int count) const { return trials > 0 ? static_cast<double>(count) / trials : 0.0; }
};

bool right(const Pose2& pose, const StandingRobot& robot) {
  return standingError(pose, robot.truth).within(kNearCm, kNearDeg) ||
         standingError(pose, robot.twin()).within(kNearCm, kNearDeg);
}

// Frames until the search has answered; none within `kMaxFrames` is -1.
int search(StandingRobot& robot, WorldModel& world) {
  robot.input.lastCommand.localise = true;
  for (int i = 0; i < kMaxFrames; ++i) {
    robot.look(false);
    world = robot.step();
    if (robot.state->search.served) return i + 1;
  }
  return -1;
}

void judge(StandingRobot& robot, Tally& tally) {
  WorldModel world;
  ++tally.trials;
  const int frames = search(robot, world);
  if (frames >= 0) {
    ++tally.answered;
    tally.seconds.push_back(frames * kFrameSeconds);
    const double away = std::min(standingError(world.pose, robot.truth).cm,
                                 standingError(world.pose, robot.twin()).cm);
    if (right(world.pose, robot)) {
      ++tally.best;
      tally.cm.push_back(away);
    }
    bool any = false;
    for (const PoseMode& mode : world.modes) any = any || right(mode.pose, robot);
    tally.any += any ? 1 : 0;
  }
  for (int i = 0; i < kLandmarkFrames; ++i) {
    robot.look(true);
    world = robot.step();
  }
  tally.known += standingError(world.pose, robot.truth).within(kNearCm, kNearDeg) ? 1 : 0;
}

}  // namespace

Expected<Json> globalLocalise(const ExperimentOptions& options) {
  Tally tally;
  for (int i = 0; i < options.trials; ++i) {
    StandingRobot robot(options.seed + static_cast<std::uint64_t>(i));
    judge(robot, tally);
    if (options.progress) options.progress(i + 1, options.trials);
  }
  return Json{{"experiment", "global-localise"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"answered_rate", tally.rate(tally.answered)},
              {"best_rate", tally.rate(tally.best)},
              {"any_mode_rate", tally.rate(tally.any)},
              {"with_landmarks_rate", tally.rate(tally.known)},
              {"mean_cm", mean(tally.cm)},
              {"median_s", percentile(tally.seconds, 0.5)},
              {"p95_s", percentile(tally.seconds, 0.95)}};
}

}  // namespace kelpie::experiments
