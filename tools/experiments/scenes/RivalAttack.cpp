// SPDX-License-Identifier: Apache-2.0
// A team (--a) against attacks that begin as those of the team of 2005 did 12 s before its goals
// (the scene rival-attack), played by another team (--b): goals against, and how soon the ball is
// won, which is when a robot of the team has been the nearest to it for a while. It cannot tell a
// ball that was won from one that the attackers ran past.
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/scenes/StagedScenes.h"

namespace kelpie::experiments {
namespace {

constexpr double kAt = 40.0;     // cm from the neck base to a ball that a robot has
constexpr double kHasFor = 0.5;  // s
constexpr double kSoon = 6.0;    // s

struct Attacks {
  Share conceded, scored, wonSoon;
  Values won;
};

// When the defenders had won the ball, s from the beginning; kNever.
double wonAfter(const Played& played) {
  if (played.moments.empty()) return kNever;
  const double begin = played.moments.front().truth.time.seconds();
  double since = -1.0;
  for (const PlayedMoment& moment : played.moments) {
    const double now = moment.truth.time.seconds();
    const sim::RobotTruth& one = nearestToBall(moment.truth);
    const bool has =
        one.team == TeamColour::red && distance(one.pose.position, moment.truth.ball) < kAt;
    if (!has) since = -1.0;
    if (has && since < 0.0) since = now;
    if (has && now - since >= kHasFor) return now - begin;
  }
  return kNever;
}

void judge(const Played& played, Attacks& attacks) {
  const double won = wonAfter(played);
  attacks.conceded.count(goalAfter(played, TeamColour::blue).has_value());
  attacks.scored.count(goalAfter(played, TeamColour::red).has_value());
  attacks.wonSoon.count(won <= kSoon);
  attacks.won.push_back(won);
}

Expected<Json> rivalAttack(const Request& request) {
  Attacks attacks;
  StagedScenes scenes;
  scenes.kinds = {"rival-attack"};
  scenes.opponents = "runner";
  scenes.judge = [&](std::size_t, const Played& played) { judge(played, attacks); };
  const Status done = playScenes(request, scenes);
  if (!done) return Error{done.error()};
  return Json{{"goals_against", attacks.conceded.value()},
              {"goals_for", attacks.scored.value()},
              {"won_within_6s_share", attacks.wonSoon.value()},
              {"won_after_median_s", percentile(attacks.won, 0.5)}};
}

const Registration kRivalAttack(
    "rival-attack", "attacks staged as those of 2005 (--b): goals, how soon --a wins the ball",
    {Option::trials, Option::seed, Option::fast, Option::side, Option::opponents}, 24, rivalAttack);

}  // namespace
}  // namespace kelpie::experiments
