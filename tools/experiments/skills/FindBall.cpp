// SPDX-License-Identifier: Apache-2.0
// How long a lost ball stays lost (checklist ): a robot goes towards a ball that it sees, then
// a hand puts the ball where it does not look. The chain of thesis 2006 figure 6.2 beside turning
// on the spot, by the same seeds; seconds from the throw until vision has the ball again, and
// rightly.
#include <array>
#include <cmath>

#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kThrown = 4.0;   // s: the robot has got up and gone for 2.5 s
constexpr double kLimit = 12.0;   // s after the throw
constexpr double kWalked = 85.0;  // cm that it has come by then, for where a robot hides the ball
constexpr double kBehind = 32.0;  // cm behind the middle of a robot the ball cannot be seen

enum Situation : std::size_t { kLeft, kRight, kChin, kBack, kHidden, kSituations };
constexpr std::array<const char*, kSituations> kNames = {"kicked_left", "kicked_right",
                                                         "under_chin", "behind", "hidden"};

// In the robot's frame: to its right, ahead.
sim::Ball thrownAway(Situation situation, Random& random) {
  const double lateral = random.uniform(35.0, 60.0);
  const double speed = random.uniform(30.0, 90.0);
  switch (situation) {
    case kLeft: return {{-lateral, 5.0}, {-speed, 0.0}};
    case kRight: return {{lateral, 5.0}, {speed, 0.0}};
    case kChin: return {{random.uniform(-2.0, 2.0), 9.0}, {}};
    default: return {{random.uniform(-25.0, 25.0), random.uniform(-110.0, -50.0)}, {}};
  }
}

void hide(const Pose2& start, Random& random, cli::SessionOptions& session) {
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const Pose2 standing{
      fieldFromRobot(start, {side * random.uniform(45.0, 70.0), random.uniform(180.0, 210.0)}),
      start.heading + Angle::deg(180.0)};
  addStanding(standing, session);
  const Point2<Field> eye = fieldFromRobot(start, {0.0, kWalked});
  const Point2<Field> middle = fieldFromRobot(standing, {0.0, -7.0});
  const Point2<Field> way = middle - eye;
  const Point2<Field> place = middle + way * (kBehind / way.norm());
  session.staging.throws = {{kThrown, {place, {}}, std::nullopt}};
}

void setUp(const Try& one, Situation situation, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const Pose2 start{{random.uniform(150.0, 210.0), random.uniform(130.0, 170.0)},
                    Angle::deg(random.uniform(80.0, 100.0))};
  session.staging.places = {placed(TeamColour::red, start)};
  session.staging.ball =
      sim::Ball{fieldFromRobot(start, robotPolar(random.uniform(170.0, 200.0), {})), {}};
  session.seconds = kThrown + kLimit;
  session.goals = 0;
  if (situation == kHidden)
    hide(start, random, session);
  else
    session.staging.throws = {
        {kThrown, thrownAway(situation, random), host::AgentHello{TeamColour::red, 1}}};
}

using All = std::array<std::vector<Searched>, 2 * kSituations>;

// Of one way: seconds of the tries that count, in one situation or in all.
Values secondsOf(const All& all, std::size_t way, std::size_t first, std::size_t end) {
  Values seconds;
  for (std::size_t situation = first; situation < end; ++situation)
    for (std::size_t i = 0; i < all[situation].size(); ++i) {
      const Searched& chain = all[situation][i];
      const Searched& spin = all[kSituations + situation][i];
      if (!chain.watched || !spin.watched || (!chain.lost && !spin.lost)) continue;
      seconds.push_back(way == 0 ? chain.seconds : spin.seconds);
    }
  return seconds;
}

Json beside(const All& all, std::size_t first, std::size_t end) {
  const Values chain = secondsOf(all, 0, first, end);
  const Values spin = secondsOf(all, 1, first, end);
  return Json{{"tries", chain.size()},
              {"chain_median_s", percentile(chain, 0.5)},
              {"spin_median_s", percentile(spin, 0.5)},
              {"chain_p90_s", percentile(chain, 0.9)},
              {"spin_p90_s", percentile(spin, 0.9)},
              {"chain_over_spin", ratio(percentile(chain, 0.5), percentile(spin, 0.5))},
              {"chain_found_rate", shareUpTo(chain, kLimit - kFrameSeconds)},
              {"spin_found_rate", shareUpTo(spin, kLimit - kFrameSeconds)}};
}

Expected<Json> findBall(const Request& request) {
  All all;
  Tries tries;
  for (const char* search : {"behaviour.task.search=0", "behaviour.task.search=1"})
    for (const char* name : kNames) tries.ways.push_back({name, {search}});
  for (auto& one : all) one.resize(static_cast<std::size_t>(request.trials));
  tries.each = request.trials;
  tries.setUp = [](const Try& one, cli::SessionOptions& session) {
    setUp(one, static_cast<Situation>(one.way % kSituations), session);
  };
  tries.judge = [&](const Try& one, const cli::SessionResult&, const Played& played) {
    all[one.way][static_cast<std::size_t>(one.trial.number)] = searchedIn(played, kThrown, kLimit);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  Json figures = beside(all, 0, kSituations);
  for (std::size_t situation = 0; situation < kSituations; ++situation)
    figures[kNames[situation]] = beside(all, situation, situation + 1);
  return figures;
}

const Registration kFindBall(
    "find-ball", "a ball put out of sight in five ways: seconds to find it, chain, spin",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 12, findBall);

}  // namespace
}  // namespace kelpie::experiments
