// SPDX-License-Identifier: Apache-2.0
// How straight a held ball is shot at the goal (checklist A-6.4.1.3): the robot stands in the far
// half with the ball just ahead of it and looks anywhere. Aiming by the goal as it is seen beside
// aiming by the pose, by the same seeds; the first shot that follows a hold counts.
#include <array>
#include <cmath>

#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 20.0;    // of a try
constexpr double kBallAhead = 26.0;  // cm, the nearest place for a ball at the start

enum : std::size_t { kBySight, kByPose, kVariants };

void setUp(const Try& one, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const Pose2 robot{{random.uniform(90.0, 270.0), random.uniform(290.0, 420.0)},
                    Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
  session.staging.places = {placed(TeamColour::red, robot)};
  session.staging.ball = sim::Ball{fieldFromRobot(robot, {0.0, kBallAhead}), {}};
  session.seconds = kSeconds;
}

Json figuresOf(const Request& request, const std::vector<Aimed>& all) {
  Json each = Json::array();
  Share shot;
  Share onTarget;
  Values errors;
  Values sizes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Aimed& found = all[i];
    shot.count(found.shot);
    if (!found.shot) continue;
    onTarget.count(found.onTarget);
    errors.push_back(found.errorDeg);
    sizes.push_back(std::fabs(found.errorDeg));
    each.push_back({{"seed", request.seed + i}, {"error_deg", found.errorDeg}});
  }
  return Json{{"shots_rate", shot.value()},
              {"on_target_rate", onTarget.value()},
              {"spread_deg", standardDeviation(errors)},
              {"middle_68_deg", 0.5 * (percentile(errors, 0.84) - percentile(errors, 0.16))},
              {"mean_deg", mean(errors)},
              {"mean_abs_deg", mean(sizes)},
              {"median_abs_deg", percentile(sizes, 0.5)},
              {"each", each}};
}

Expected<Json> aim(const Request& request) {
  std::array<std::vector<Aimed>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"sight", {"behaviour.task.aiming=0"}}, {"pose", {"behaviour.task.aiming=1"}}};
  tries.each = request.trials;
  tries.setUp = setUp;
  tries.judge = [&](const Try& one, const cli::SessionResult&, const Played& played) {
    found[one.way][static_cast<std::size_t>(one.trial.number)] = aimedIn(played);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  return Json{{"sight", figuresOf(request, found[kBySight])},
              {"pose", figuresOf(request, found[kByPose])}};
}

const Registration kAim("aim", "shots of a held ball: spread about the goal, by sight and by pose",
                        {Option::trials, Option::seed, Option::randomised, Option::params,
                         Option::fast},
                        40, aim);

}  // namespace
}  // namespace kelpie::experiments
