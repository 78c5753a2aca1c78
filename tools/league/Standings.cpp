// SPDX-License-Identifier: Apache-2.0
#include "tools/league/Standings.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace kelpie::league {
namespace {

using SeedDifferences = std::map<int, Differences>;  // by draw: one for each pair that played it

struct Tally {
  Score score;
  SeedDifferences differences;
};

// A match as its red or its blue side sees it.
Score scoreOf(const MatchResult& result, bool red) {
  Score score;
  score.matches = 1;
  score.goals = red ? result.redGoals : result.blueGoals;
  score.against = red ? result.blueGoals : result.redGoals;
  score.ownGoals = red ? result.redOwnGoals : result.blueOwnGoals;
  score.wins = score.goals > score.against ? 1 : 0;
  score.losses = score.goals < score.against ? 1 : 0;
  score.draws = 1 - score.wins - score.losses;
  return score;
}

void add(const Score& from, Score& to) {
  to.matches += from.matches;
  to.wins += from.wins;
  to.draws += from.draws;
  to.losses += from.losses;
  to.goals += from.goals;
  to.against += from.against;
  to.ownGoals += from.ownGoals;
}

void add(int draw, const Score& both, Tally& tally) {
  add(both, tally.score);
  tally.differences[draw].push_back(static_cast<double>(both.goals - both.against) / both.matches);
}

bool isPlayedOut(const std::optional<MatchResult>& result) {
  return result && result->trouble.empty();
}

class Counting {
 public:
  explicit Counting(const LeagueRecord& league)
      : league_(league),
        pairings_(pairingsOf(league.plan)),
        sides_(league.plan.sides.size()),
        pairs_(pairings_.size()) {
    const auto schedule = scheduleOf(league.plan);
    standings_.plan = league.plan;
    standings_.matches = schedule.size();
    for (std::size_t i = 0; i + 1 < schedule.size(); i += 2) countSeed(i, schedule[i]);
    for (std::size_t i = 0; i < schedule.size(); ++i) countTrouble(i, schedule[i].match);
  }

  Standings finish(const Resampling& params) {
    for (std::size_t i = 0; i < sides_.size(); ++i)
      standings_.sides.push_back(
          {league_.plan.sides[i], sides_[i].score, statisticsOf(bySeed(sides_[i]), params)});
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      standings_.pairs.push_back({league_.plan.sides[pairings_[i].first],
                                  league_.plan.sides[pairings_[i].second], pairs_[i].score,
                                  statisticsOf(bySeed(pairs_[i]), params)});
    std::sort(standings_.sides.begin(), standings_.sides.end(), isBefore);
    return std::move(standings_);
  }

 private:
  // The two matches of a seed stand next to each other, the second with colours exchanged.
  void countSeed(std::size_t match, const ScheduledMatch& scheduled) {
    const auto& one = league_.results[match];
    const auto& other = league_.results[match + 1];
    if (!isPlayedOut(one) || !isPlayedOut(other)) {
      standings_.unpaired += isPlayedOut(one) || isPlayedOut(other) ? 1U : 0U;
      return;
    }
    standings_.counted += 2;
    Score first = scoreOf(*one, true);
    add(scoreOf(*other, false), first);
    Score second = scoreOf(*one, false);
    add(scoreOf(*other, true), second);
    const Pairing pairing = pairings_[scheduled.pairing];
    add(scheduled.draw, first, pairs_[scheduled.pairing]);
    add(scheduled.draw, first, sides_[pairing.first]);
    add(scheduled.draw, second, sides_[pairing.second]);
  }

  void countTrouble(std::size_t number, const LeagueMatch& match) {
    const auto& result = league_.results[number];
    if (!result || result->trouble.empty()) return;
    ++standings_.voids;
    standings_.troubles.push_back(fmt::format("match {}, red {}, blue {}, seed {}: {}", number,
                                              match.red, match.blue, match.seed, result->trouble));
  }

  static Differences bySeed(const Tally& tally) {
    Differences means;
    for (const auto& [draw, differences] : tally.differences) means.push_back(meanOf(differences));
    return means;
  }

  static bool isBefore(const SideStanding& a, const SideStanding& b) {
    const auto key = [](const SideStanding& side) {
      return std::tuple(-side.score.points(), -side.difference.mean, -side.score.goals);
    };
    return std::pair(key(a), a.name) < std::pair(key(b), b.name);
  }

  const LeagueRecord& league_;
  std::vector<Pairing> pairings_;
  std::vector<Tally> sides_;
  std::vector<Tally> pairs_;
  Standings standings_;
};

}  // namespace

Standings standingsOf(const LeagueRecord& league, const Resampling& params) {
  return Counting(league).finish(params);
}

}  // namespace kelpie::league
