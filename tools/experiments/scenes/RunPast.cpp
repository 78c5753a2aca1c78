// SPDX-License-Identifier: Apache-2.0
// Running with the ball: one forward (--a) pushes it 250 cm up-field past an opponent who stands in
// the way. How fast the ball gets there, and whether it is the forward's still. It takes an
// opponent within 200 cm as pressing and shoots at an open goal alone, so that it runs all the way.
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/scenes/StagedScenes.h"

namespace kelpie::experiments {
namespace {

constexpr double kWay = 250.0;   // cm
constexpr double kLimit = 20.0;  // s
constexpr double kPushed = 2.0;  // cm that a ball moves which is pushed
constexpr double kWith = 70.0;   // cm from the forward to a ball that is its own
constexpr std::uint8_t kRunner = 2;

struct Way {
  bool kept = false;
  double speed = 0.0;  // cm/s, net
};

// From the first push on.
Way judge(const Played& played) {
  if (played.moments.empty()) return {};
  const PlayedMoment& first = played.moments.front();
  const double out = played.outAfter(first.seconds()).value_or(first.seconds() + kLimit);
  double pushed = -1.0;
  for (const PlayedMoment& moment : played.moments) {
    if (moment.seconds() >= out) return {};
    if (distance(moment.truth.ball, first.truth.ball) < kPushed) continue;
    if (pushed < 0.0) pushed = moment.seconds();
    if (moment.truth.ball.y - first.truth.ball.y < kWay) continue;
    const Pose2* runner = redPose(moment.truth, kRunner);
    return {runner != nullptr && distance(runner->position, moment.truth.ball) <= kWith,
            kWay / (moment.seconds() - pushed)};
  }
  return {};
}

Expected<Json> runPast(const Request& request) {
  Share kept;
  Values speeds;
  StagedScenes scenes;
  scenes.kinds = {"ahead"};
  scenes.opponents = "../tools/experiments/skills/standing";
  scenes.set = {"behaviour.constants.run.pressed=200cm", "behaviour.constants.run.shot=0.9"};
  scenes.judge = [&](std::size_t, const Played& played) {
    const Way way = judge(played);
    kept.count(way.kept);
    if (way.kept) speeds.push_back(way.speed);
  };
  const Status done = playScenes(request, scenes);
  if (!done) return Error{done.error()};
  return Json{{"kept_share", kept.value()},
              {"speed_median_cm_s", percentile(speeds, 0.5)},
              {"speed_p10_cm_s", percentile(speeds, 0.1)}};
}

const Registration kRunPast(
    "run", "a ball pushed 250 cm ahead past one who stands in the way: kept, cm/s",
    {Option::trials, Option::seed, Option::fast, Option::side, Option::opponents}, 60, runPast);

}  // namespace
}  // namespace kelpie::experiments
