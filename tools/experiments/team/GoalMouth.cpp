// SPDX-License-Identifier: Apache-2.0
// Scrums before a goal, one every ten seconds of a match by the rules: the ball is put there,
// two attackers of the other team near it and one more of the own, who turn to it. How many become
// goals, and own goals: matches have one own goal in forty minutes, too few to tell two goalies
// apart. The goalie stands where the scrum before has left it.
#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/skills/Tries.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 240.0;  // of play
constexpr double kFirst = 45.0;     // s from the start to the first scrum,
constexpr double kLast = 360.0;     // and to the last; a match ends sooner or later
constexpr double kEvery = 10.0;
constexpr double kAway = 0.4;     // s without a ball, in which robots are put down
constexpr int kInARow = 3;        // before the same goal
constexpr double kMargin = 20.0;  // cm from the lines

// How far from the ball somebody is put, in cm.
struct Range {
  double low = 0.0, high = 0.0;
};
constexpr Range kNearer{40.0, 100.0}, kFarther{60.0, 160.0}, kDefender{50.0, 160.0};

struct Found {
  int scrums = 0, goals = 0, ownGoals = 0;
};

// A place about the ball, up-field of it more often than not, that looks at it roughly.
Pose2 placeAbout(Point2<Field> ball, Range range, const body::FieldDescription& field,
                 Random& random) {
  const Angle way = Angle::deg(90.0 + random.uniform(-100.0, 100.0));
  const double away = random.uniform(range.low, range.high);
  const maths::SinCos sc = way.sinCos();
  const Point2<Field> at{std::clamp(ball.x + away * sc.cos, kMargin, field.width - kMargin),
                         std::clamp(ball.y + away * sc.sin, kMargin, field.length - kMargin)};
  return {at, headingTo(at, ball) + Angle::deg(random.uniform(-30.0, 30.0))};
}

void stage(double time, TeamColour goal, const body::FieldDescription& field, Random& random,
           sim::Staging& staging) {
  const Point2<Field> ball{0.5 * field.width + random.uniform(-75.0, 75.0),
                           random.uniform(25.0, 95.0)};
  staging.takes.push_back({time, kAway, sim::ownView(field, goal, ball)});
  const auto put = [&](TeamColour team, std::uint8_t player, Range range) {
    const Pose2 pose = sim::ownView(field, goal, placeAbout(ball, range, field, random));
    staging.carries.push_back({time + 0.25 * kAway, {team, player}, pose});
  };
  put(sim::otherTeam(goal), 2, kNearer);
  put(sim::otherTeam(goal), 3, kFarther);
  put(goal, 2, kDefender);
}

sim::Staging scrums(std::uint64_t seed) {
  const body::FieldDescription field;
  Random random(seed ^ 0x5c12a3ULL);
  sim::Staging staging;
  int number = 0;
  for (double time = kFirst; time < kLast; time += kEvery)
    stage(time, number++ / kInARow % 2 == 0 ? TeamColour::red : TeamColour::blue, field, random,
          staging);
  return staging;
}

void judge(const TeamMatch& match, Found& found) {
  for (const sim::MatchEvent& event : match.events) {
    found.scrums += event.kind == sim::EventKind::returned ? 1 : 0;
    found.goals += event.kind == sim::EventKind::goal ? 1 : 0;
    found.ownGoals += isOwnGoal(event) ? 1 : 0;
  }
}

Expected<Json> goalMouth(const Request& request) {
  Found found;
  const auto each = [&](const cli::SessionResult&, const TeamMatch& match) { judge(match, found); };
  const Status played = playFours(request, {kSeconds, Kept::world, scrums}, each);
  if (!played) return Error{played.error()};
  return Json{{"scrums", found.scrums},
              {"goals", found.goals},
              {"goals_share", ratio(found.goals, found.scrums)},
              {"own_goals", found.ownGoals},
              {"own_goals_share", ratio(found.ownGoals, found.goals)}};
}

const Registration kGoalMouth(
    "goal-mouth", "scrums before a goal: how many become goals, and own goals",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 6, goalMouth);

}  // namespace
}  // namespace kelpie::experiments
