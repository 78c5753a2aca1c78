// SPDX-License-Identifier: Apache-2.0
// Running with the ball: one forward (--a) pushes it 250 cm up-field past an opponent who stands in
// the way. How fast the ball gets there, and whether it is the forward's still. It takes an
// opponent within 200 cm as pressing and shoots at an open goal alone, so that it runs all the way.
#include <cmath>

#include "robot/core/Random.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/StagedScenes.h"

namespace kelpie::experiments {
namespace {

constexpr double kWay = 250.0;    // cm
constexpr double kLimit = 20.0;   // s
constexpr double kWith = 70.0;    // cm from the forward to a ball that is its own
constexpr double kStart = 140.0;  // cm, of the ball from the own goal line
constexpr double kAside = 60.0;   // cm from the middle of the field, at most
constexpr double kBehind = 35.0;  // cm from the ball to the forward
constexpr double kOff = 15.0;     // cm that forward and opponent are aside of the ball, at most
constexpr double kKeeper = 22.0;  // cm from its line to the goalie
constexpr std::uint8_t kRunner = 2;

struct Way {
  bool kept = false;
  double speed = 0.0;  // cm/s, net
};

Pose2 runnerOf(const PlayedMoment& moment) {
  for (const sim::RobotTruth& one : moment.truth.robots)
    if (one.team == TeamColour::red && one.player == kRunner) return one.pose;
  return {};
}

Way judge(const Played& played) {
  if (played.moments.empty()) return {};
  const PlayedMoment& first = played.moments.front();
  const double out = played.outAfter(first.seconds()).value_or(first.seconds() + kLimit);
  for (const PlayedMoment& moment : played.moments) {
    if (moment.seconds() >= out) return {};
    if (moment.truth.ball.y - first.truth.ball.y < kWay) continue;
    const bool with = distance(runnerOf(moment).position, moment.truth.ball) <= kWith;
    return {with, kWay / (moment.seconds() - first.seconds())};
  }
  return {};
}

// The opponent looks at who comes, within a body's width of the straight way.
Expected<sim::StagedScene> drawn(const body::FieldDescription& field, std::uint64_t seed) {
  Random random(seed ^ 0x7219e55ULL);
  const double x = 0.5 * field.width + random.uniform(-kAside, kAside);
  const Angle up = Angle::deg(90.0), down = Angle::deg(-90.0);
  sim::StagedScene scene;
  scene.robots = "2v1";
  scene.seconds = kLimit;
  scene.staging.ball = sim::Ball{{x, kStart}, {}};
  scene.staging.places = {
      {{TeamColour::red, 1}, {{0.5 * field.width, kKeeper}, up}},
      {{TeamColour::red, kRunner}, {{x + random.uniform(-kOff, kOff), kStart - kBehind}, up}},
      {{TeamColour::blue, 1}, {{x + random.uniform(-kOff, kOff), kStart + 0.5 * kWay}, down}}};
  return scene;
}

Expected<Json> runPast(const Request& request) {
  Share kept;
  Values speeds;
  StagedScenes scenes;
  scenes.draw = [](std::size_t, const body::FieldDescription& field, std::uint64_t seed) {
    return drawn(field, seed);
  };
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

const Registration kRunPast("run",
                            "a ball pushed 250 cm ahead past one who stands in the way: kept, cm/s",
                            {Option::trials, Option::seed, Option::fast, Option::sides}, 60,
                            runPast);

}  // namespace
}  // namespace kelpie::experiments
