// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/TeamPairs.h"

#include "tools/experiments/team/TeamMatch.h"
#include "tools/league/PairedStatistics.h"

namespace kelpie::experiments {
namespace {

constexpr double kMinutes = 4.0;
constexpr int kOfPair = 2;  // matches of a seed

Expected<cli::SessionOptions> sessionFor(const Request& request, const TwoSides& sides, int number,
                                         double minutes) {
  auto session = teamSession(request, trialOf(request, number / kOfPair), "4v4", minutes * 60.0);
  if (!session) return session;
  session->keepAll = false;
  for (std::size_t side = 0; side < sides.size(); ++side)
    giveParam(sides[side].param, colourOf(side, number % kOfPair), *session);
  return session;
}

std::array<SideTally, 2> sidesOf(const Played& played, int match) {
  return {tallyOf(played, colourOf(0, match)), tallyOf(played, colourOf(1, match))};
}

}  // namespace

void SideTally::add(const SideTally& other) {
  goals += other.goals;
  ownGoals += other.ownGoals;
  outs += other.outs;
}

SideTally tallyOf(const Played& played, TeamColour team) {
  SideTally tally;
  for (const sim::MatchEvent& event : played.events) {
    const bool goal = event.kind == sim::EventKind::goal;
    const bool own = isOwnGoal(event);
    tally.goals += goal && event.team == team ? 1 : 0;
    tally.ownGoals += own && event.team != team ? 1 : 0;
    tally.outs += event.kind == sim::EventKind::out && event.team == team ? 1 : 0;
  }
  return tally;
}

TeamColour colourOf(std::size_t side, int match) {
  return (side == 0) == (match == 0) ? TeamColour::red : TeamColour::blue;
}

void giveParam(const char* param, TeamColour team, cli::SessionOptions& session) {
  const std::string name = team == TeamColour::red ? "red" : "blue";
  if (session.team == name) session.set.emplace_back(param);
  for (cli::OtherRobot& robot : session.others)
    if (robot.team == name) robot.set.emplace_back(param);
}

Json figuresOf(const TwoSides& sides, const PairsTally& tally) {
  const auto matches = static_cast<double>(kOfPair * tally.differences.size());
  const league::Interval interval = league::bootstrap(tally.differences, {});
  Json figures{{"matches", matches},
               {"difference_per_match", mean(tally.differences)},
               {"difference_low", interval.low},
               {"difference_high", interval.high}};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const SideTally& side = tally.sides[i];
    figures[sides[i].name] =
        Json{{"goals_per_match", ratio(side.goals, matches)},
             {"goals_against_per_match", ratio(tally.sides[1 - i].goals, matches)},
             {"own_goals_per_match", ratio(side.ownGoals, matches)},
             {"outs_per_match", ratio(side.outs, matches)}};
  }
  return figures;
}

Expected<Json> comparePairs(const Request& request, const TwoSides& sides) {
  const double minutes = request.minutes > 0.0 ? request.minutes : kMinutes;
  PairsTally tally;
  tally.differences.resize(static_cast<std::size_t>(request.trials));
  Matches matches;
  matches.count = kOfPair * request.trials;
  matches.session = [&](int number) { return *sessionFor(request, sides, number, minutes); };
  matches.judge = [&](int number, const cli::SessionResult&, const Played& played) {
    const auto found = sidesOf(played, number % kOfPair);
    for (std::size_t i = 0; i < found.size(); ++i) tally.sides[i].add(found[i]);
    tally.differences[static_cast<std::size_t>(number / kOfPair)] +=
        (found[0].goals - found[1].goals) / static_cast<double>(kOfPair);
  };
  const Status played = playMatches(request, matches);
  if (!played) return Error{played.error()};
  Json figures{{"minutes", minutes}};
  figures.update(figuresOf(sides, tally));
  return figures;
}

}  // namespace kelpie::experiments
