// SPDX-License-Identifier: Apache-2.0
// The search over the field by lines alone: robots at random places stand and look about until the
// search that was asked for has answered. The heaviest mode and any mode are compared with the pose
// and its twin, within 20 cm and 10 deg (checklist M43); then landmarks are seen too for two
// seconds, and the twin no longer counts.
#include <algorithm>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kMaxFrames = 450;
constexpr int kLandmarkFrames = 60;
constexpr double kSuccessCm = 20.0;
constexpr double kSuccessDeg = 10.0;

struct Tally {
  Share answered;
  Share best;
  Share any;
  Share known;
  Values cm;       // of the best mode, if right
  Values seconds;  // until the answer
};

bool right(const Pose2& pose, const sim::StandingRobot& robot) {
  return sim::beliefError(pose, robot.truth.pose()).within(kSuccessCm, kSuccessDeg) ||
         sim::beliefError(pose, robot.twin()).within(kSuccessCm, kSuccessDeg);
}

// Frames until the search has answered; none within `kMaxFrames` is -1.
int search(sim::StandingRobot& robot, WorldModel& world) {
  robot.input.lastCommand.localise = true;
  for (int i = 0; i < kMaxFrames; ++i) {
    robot.look(false);
    world = robot.step();
    if (robot.state.lines.searchServed) return i + 1;
  }
  return -1;
}

void searchAndLook(sim::StandingRobot& robot, Tally& tally) {
  WorldModel world;
  const int frames = search(robot, world);
  const bool answered = frames >= 0;
  tally.answered.count(answered);
  if (answered) tally.seconds.push_back(frames * kFrameSeconds);
  const bool best = answered && right(world.pose, robot);
  tally.best.count(best);
  if (best)
    tally.cm.push_back(std::min(sim::beliefError(world.pose, robot.truth.pose()).cm,
                                sim::beliefError(world.pose, robot.twin()).cm));
  tally.any.count(answered && std::any_of(world.modes.begin(), world.modes.end(),
                                          [&](const PoseMode& m) { return right(m.pose, robot); }));
  for (int i = 0; i < kLandmarkFrames; ++i) {
    robot.look(true);
    world = robot.step();
  }
  tally.known.count(
      sim::beliefError(world.pose, robot.truth.pose()).within(kSuccessCm, kSuccessDeg));
}

Expected<Json> globalLocalise(const Request& request) {
  Tally tally;
  eachTrial(request, [&](const Trial& trial) {
    sim::StandingRobot robot(trial.seed);
    searchAndLook(robot, tally);
  });
  return Json{{"answered_rate", tally.answered.value()},
              {"best_rate", tally.best.value()},
              {"any_mode_rate", tally.any.value()},
              {"with_landmarks_rate", tally.known.value()},
              {"mean_cm", mean(tally.cm)},
              {"median_s", percentile(tally.seconds, 0.5)},
              {"p95_s", percentile(tally.seconds, 0.95)}};
}

const Registration kGlobalLocalise(
    "global-localise", "the search by lines alone: pose or twin, time; then with landmarks",
    {Option::trials, Option::seed}, 200, globalLocalise);

}  // namespace
}  // namespace kelpie::experiments
