// SPDX-License-Identifier: Apache-2.0
// Which kick (checklist ): the rules of thesis 2006 beside the map of where each kick sends
// the ball, by the same seeds, from anywhere in front of the goal of 2006's goalie.
#include <array>

#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 40.0;  // of a try
constexpr double kApart = 40.0;    // cm between robot and ball

enum : std::size_t { kByRules, kByMap, kVariants };

struct Found {
  bool scored = false;
  double seconds = kSeconds;
  int ownGoals = 0;
  int outs = 0;
};

void setUp(const Try& one, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  Pose2 robot;
  Point2<Field> ball;
  do {
    robot = {{random.uniform(50.0, 310.0), random.uniform(150.0, 420.0)},
             Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
    ball = {random.uniform(40.0, 320.0), random.uniform(200.0, 460.0)};
  } while (distance(robot.position, ball) < kApart);
  session.scenario = "attack";
  session.staging.places = {placed(TeamColour::red, robot)};
  session.staging.ball = sim::Ball{ball, {}};
  session.seconds = kSeconds;
  addKeeper(PlayerKind::goalie, session);
  session.staging.places.push_back(placed(TeamColour::blue, {{180.0, 520.0}, Angle::deg(-90.0)}));
}

Json figuresOf(const std::vector<Found>& all) {
  Share scored;
  Values seconds;
  double outs = 0.0;
  int ownGoals = 0;
  for (const Found& found : all) {
    scored.count(found.scored);
    seconds.push_back(found.seconds);
    outs += found.outs;
    ownGoals += found.ownGoals;
  }
  return Json{{"goals_rate", scored.value()},
              {"median_s", percentile(seconds, 0.5)},
              {"mean_s", mean(seconds)},
              {"outs_a_try", ratio(outs, static_cast<double>(all.size()))},
              {"own_goals", ownGoals}};
}

Expected<Json> kickChoice(const Request& request) {
  std::array<std::vector<Found>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"rules", {"behaviour.task.kicks=0"}}, {"map", {"behaviour.task.kicks=1"}}};
  tries.each = request.trials;
  tries.setUp = setUp;
  tries.judge = [&](const Try& one, const cli::SessionResult& result, const Played&) {
    const bool scored = !result.goals.empty();
    found[one.way][static_cast<std::size_t>(one.trial.number)] = {
        scored, scored ? result.goals[0] : kSeconds, static_cast<int>(result.ownGoals.size()),
        result.outs};
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  return Json{{"rules", figuresOf(found[kByRules])}, {"map", figuresOf(found[kByMap])}};
}

const Registration kKickChoice(
    "kick-choice", "goals a try against a goalie: the thesis' kick rules and the kick map",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 40,
    kickChoice);

}  // namespace
}  // namespace kelpie::experiments
