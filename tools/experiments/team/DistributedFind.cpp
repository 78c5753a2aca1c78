// SPDX-License-Identifier: Apache-2.0
// How long a ball stays lost that nobody of a team sees (checklist A-6.2.2.1): three forwards play
// towards a ball, then a hand puts it behind an opponent far up the field. The common search, each
// to a place of its own, beside each robot's own search, by the same seeds; seconds from the throw
// until one of them has the ball. Pairs in which it was in sight at once do not count.
#include <array>
#include <cmath>

#include "tools/experiments/skills/Tries.h"
#include "tools/experiments/team/TeamSearch.h"

namespace kelpie::experiments {
namespace {

constexpr double kThrown = 3.5;  // s
constexpr double kLimit = 40.0;  // s after the throw
constexpr double kUnseen = 1.0;  // s; found within, it was not hidden
// cm from the middle of a body seen from the side to the ball close behind it: unseen from 30 deg
// to either side.
constexpr double kBehind = 18.0;
constexpr double kMiddle = 5.0;  // cm from the neck base back to that middle

enum : std::size_t { kTogether, kAlone, kVariants };
constexpr std::array<const char*, kVariants> kSet = {"behaviour.task.distributedFind=true",
                                                     "behaviour.task.distributedFind=false"};

void addForward(std::uint8_t player, const Pose2& pose, const std::string& word,
                cli::SessionOptions& session) {
  session.staging.places.push_back(placed(TeamColour::red, pose, player));
  if (player == 2) return;  // the watched one
  cli::OtherRobot mate;
  mate.team = "red";
  mate.player = player;
  mate.params = session.params;
  mate.set = {word};
  mate.seed = session.seed + player;
  session.others.push_back(mate);
}

// The ball is put far up the field, an opponent stands between it and the forwards, its side to
// them.
void hide(Point2<Field> from, Random& random, cli::SessionOptions& session) {
  const Point2<Field> ball{random.uniform(70.0, 290.0), random.uniform(430.0, 490.0)};
  const Point2<Field> way = (from - ball) * (1.0 / distance(from, ball));
  const Angle along = Angle::rad(maths::atan2(way.y, way.x));
  const Angle heading = along + Angle::deg(random.chance(0.5) ? 90.0 : -90.0);
  const maths::SinCos h = heading.sinCos();
  const Point2<Field> neck = ball + way * kBehind + Point2<Field>{h.cos, h.sin} * kMiddle;
  addStanding({neck, heading}, session);
  session.staging.throws = {{kThrown, {ball, {}}, std::nullopt}};
}

cli::SessionOptions sessionFor(const Request& request, const Try& one) {
  cli::SessionOptions session = sessionOf(request, one.trial);
  Random random = drawsOf(one);
  session.team = "red";
  session.player = 2;
  session.set = {kSet[one.way]};
  session.scenario = "kickoff";
  session.seconds = kThrown + kLimit;
  session.goals = 0;
  session.keepFrames = session.keepAll = true;
  const Point2<Field> ball{random.uniform(150.0, 210.0), random.uniform(220.0, 250.0)};
  const auto up = [&] { return Angle::deg(random.uniform(75.0, 105.0)); };
  addForward(2, {{ball.x, ball.y - random.uniform(120.0, 140.0)}, up()}, kSet[one.way], session);
  for (const std::uint8_t player : {std::uint8_t{3}, std::uint8_t{4}}) {
    const double side = player == 3 ? -1.0 : 1.0;
    const Point2<Field> place{ball.x + side * random.uniform(60.0, 90.0),
                              random.uniform(90.0, 130.0)};
    addForward(player, {place, up()}, kSet[one.way], session);
  }
  session.staging.ball = sim::Ball{ball, {}};
  hide({ball.x, 190.0}, random, session);
  return session;
}

using Seconds = std::vector<std::optional<double>>;  // of the tries of one way

// Of the pairs that count.
Json figuresOf(const std::array<Seconds, kVariants>& all, std::size_t way) {
  Share found;
  Values seconds;
  for (std::size_t i = 0; i < all[way].size(); ++i) {
    bool hidden = true;
    for (const Seconds& one : all) hidden = hidden && one[i].value_or(kLimit) > kUnseen;
    if (!hidden) continue;
    found.count(all[way][i].has_value());
    seconds.push_back(all[way][i].value_or(kLimit));
  }
  return Json{{"pairs", found.all},
              {"found_rate", found.value()},
              {"median_s", percentile(seconds, 0.5)},
              {"mean_s", mean(seconds)},
              {"p90_s", percentile(seconds, 0.9)}};
}

Expected<Json> distributedFind(const Request& request) {
  std::array<Seconds, kVariants> found;
  for (Seconds& one : found) one.resize(static_cast<std::size_t>(request.trials));
  const auto tryOf = [&](int number) {
    return Try{static_cast<std::size_t>(number) % kVariants,
               trialOf(request, number / static_cast<int>(kVariants))};
  };
  TeamMatches matches;
  matches.count = request.trials * static_cast<int>(kVariants);
  matches.session = [&](int number) { return sessionFor(request, tryOf(number)); };
  matches.judge = [&](int number, const cli::SessionResult&, const TeamMatch& match) {
    const Try one = tryOf(number);
    found[one.way][static_cast<std::size_t>(one.trial.number)] =
        foundAfter(match, TeamColour::red, kThrown);
  };
  const Status played = playTeams(request, matches);
  if (!played) return Error{played.error()};
  return Json{{"together", figuresOf(found, kTogether)}, {"alone", figuresOf(found, kAlone)}};
}

const Registration kDistributedFind(
    "distributed-find", "a ball hidden from three forwards: seconds, searched together and alone",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 40,
    distributedFind);

}  // namespace
}  // namespace kelpie::experiments
