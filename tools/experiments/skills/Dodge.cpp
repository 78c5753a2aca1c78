// SPDX-License-Identifier: Apache-2.0
// Past who stands in the way (checklist ): an opponent stands between the ball and the goal.
// With the dodge and without, by the same seeds: tries in which the ball gets past it, and shots
// that do.
#include <array>

#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 25.0;  // of a try

enum : std::size_t { kDodging, kPlain, kVariants };

struct Found {
  bool scored = false;
  Dodged dodged;
};

const Point2<Field> kGoal{180.0, 540.0};

void setUp(const Try& one, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const Point2<Field> place{random.uniform(120.0, 240.0), random.uniform(220.0, 280.0)};
  const Pose2 robot{place, headingTo(place, kGoal)};
  const Point2<Field> ball = fieldFromRobot(robot, {random.uniform(-8.0, 8.0), 45.0});
  const Pose2 opponent{
      fieldFromRobot(robot, {random.uniform(-8.0, 8.0), 45.0 + random.uniform(60.0, 90.0)}),
      robot.heading + Angle::deg(180.0)};
  session.staging.places = {placed(TeamColour::red, robot)};
  session.staging.ball = sim::Ball{ball, {}};
  session.seconds = kSeconds;
  addStanding(opponent, session);
}

Json figuresOf(const std::vector<Found>& all) {
  Share scored;
  Share passed;
  Share shots;
  for (const Found& found : all) {
    scored.count(found.scored);
    passed.count(found.dodged.passed);
    shots.add(found.dodged.shots);
  }
  return Json{{"passed_rate", passed.value()},
              {"shots", shots.all},
              {"shots_passed_rate", shots.value()},
              {"goals_rate", scored.value()}};
}

Expected<Json> dodge(const Request& request) {
  std::array<std::vector<Found>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"dodge", {"behaviour.task.dodge=true"}},
                {"no_dodge", {"behaviour.task.dodge=false"}}};
  tries.each = request.trials;
  tries.setUp = setUp;
  tries.judge = [&](const Try& one, const cli::SessionResult& result, const Played& played) {
    found[one.way][static_cast<std::size_t>(one.trial.number)] = {!result.goals.empty(),
                                                                  dodgedIn(played, kSeconds)};
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  return Json{{"dodge", figuresOf(found[kDodging])}, {"no_dodge", figuresOf(found[kPlain])}};
}

const Registration kDodge(
    "dodge", "an opponent in the way: the ball past it, with dodge and without",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 40, dodge);

}  // namespace
}  // namespace kelpie::experiments
