// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/league/RandomPlay.h"
#include "tools/league/Standings.h"

namespace kelpie::league {
namespace {

LeaguePlan twoSides(int matches) {
  LeaguePlan plan;
  plan.sides = {"a", "b"};
  plan.matchesAPair = matches;
  return plan;
}

MatchResult goals(int red, int blue) {
  MatchResult result;
  result.redGoals = red;
  result.blueGoals = blue;
  return result;
}

TEST(Standings, TheTwoMatchesOfASeedAreOneObservation) {
  LeagueRecord league{twoSides(4), {goals(3, 1), goals(0, 1), goals(2, 2), goals(4, 0)}};
  const Standings standings = standingsOf(league);
  const PairStanding& pair = standings.pairs[0];
  EXPECT_EQ(pair.difference.count, 2U);
  EXPECT_DOUBLE_EQ(pair.difference.mean, (1.5 - 2.0) / 2.0);
  EXPECT_EQ(pair.score.goals, 6);
  EXPECT_EQ(pair.score.against, 7);
  EXPECT_EQ(pair.score.wins, 2);
  EXPECT_EQ(pair.score.draws, 1);
  EXPECT_EQ(pair.score.losses, 1);
  EXPECT_EQ(standings.sides[0].name, "a");
  EXPECT_EQ(standings.sides[0].score.points(), 7);
  EXPECT_EQ(standings.sides[1].score.points(), 4);
  EXPECT_DOUBLE_EQ(standings.sides[1].difference.mean, 0.25);
}

TEST(Standings, ASeedWithoutItsOtherMatchCountsNowhereButIsReported) {
  LeagueRecord league{twoSides(6), {goals(3, 1), goals(0, 1), goals(9, 0), {}, {}, {}}};
  league.results[3] = MatchResult{};
  league.results[3]->trouble = "died";
  league.results[4].reset();
  league.results[5].reset();
  const Standings standings = standingsOf(league);
  EXPECT_EQ(standings.counted, 2U);
  EXPECT_EQ(standings.voids, 1U);
  EXPECT_EQ(standings.unpaired, 1U);
  EXPECT_EQ(standings.left(), 2U);
  EXPECT_EQ(standings.sides[0].score.matches, 2);
  EXPECT_EQ(standings.pairs[0].score.goals, 4);
}

TEST(Standings, OwnGoalsAreOfWhoShotThem) {
  LeagueRecord league{twoSides(2), {goals(0, 2), goals(1, 0)}};
  league.results[0]->redOwnGoals = 1;   // a's
  league.results[1]->blueOwnGoals = 1;  // a's again
  const Standings standings = standingsOf(league);
  EXPECT_EQ(standings.pairs[0].score.ownGoals, 2);
  EXPECT_EQ(standings.pairs[0].score.against, 3);
  EXPECT_EQ(standings.sides[0].name, "b");
  EXPECT_EQ(standings.sides[0].score.ownGoals, 0);
}

TEST(Standings, AStrongerSideIsFoundAndTheOrderIsByPoints) {
  LeaguePlan plan = smallPlan();
  plan.matchesAPair = 40;
  RandomPlay play;
  play.strength = {{"a", 0.5}, {"b", 2.0}, {"c", 4.0}};
  const Standings standings = standingsOf(playedLeague(plan, play));
  EXPECT_EQ(standings.sides[0].name, "c");
  EXPECT_EQ(standings.sides[2].name, "a");
  for (const PairStanding& pair : standings.pairs) {
    EXPECT_LT(pair.difference.signFlip.p.twoSided, 0.05) << pair.first << pair.second;
    EXPECT_LT(pair.difference.bootstrap.high, 0.0) << pair.first << pair.second;
  }
}

// Two hundred leagues of two equal sides, where red has an advantage that the exchange takes out.
struct EqualLeagues {
  std::vector<double> p;     // two-sided, of the signs
  std::vector<double> tail;  // one-sided
  int held = 0;              // bootstrap intervals that hold 0
  int heldByT = 0;           // intervals by t that do

  EqualLeagues() {
    RandomPlay play;
    play.redAdvantage = 1.0;
    LeaguePlan plan = twoSides(32);
    Resampling params;
    params.resamples = 1000;
    for (int league = 0; league < 200; ++league) {
      params.seed = static_cast<std::uint64_t>(league);
      plan.seed = 1000 * static_cast<std::uint64_t>(league + 1);
      add(standingsOf(playedLeague(plan, play), params).pairs[0].difference);
    }
  }

  void add(const PairedStatistics& of) {
    const auto holdsZero = [](const Interval& i) { return i.low <= 0.0 && 0.0 <= i.high; };
    p.push_back(of.signFlip.p.twoSided);
    tail.push_back(of.signFlip.p.oneSided);
    held += holdsZero(of.bootstrap) ? 1 : 0;
    heldByT += holdsZero(*of.student) ? 1 : 0;
  }
};

// How far the distribution of these p goes beyond the uniform one, and how far it stays below it
// (Kolmogorov and Smirnov's one-sided distances).
struct FromUniform {
  double above = 0.0;
  double below = 0.0;

  explicit FromUniform(std::vector<double> p) {
    std::sort(p.begin(), p.end());
    const auto count = static_cast<double>(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto rank = static_cast<double>(i);
      above = std::max(above, (rank + 1.0) / count - p[i]);
      below = std::max(below, p[i] - rank / count);
    }
  }
};

// One in a hundred samples of 200 goes 0.107 beyond. Sums of whole goals are often the same: 7 % of
// them are 0, where p is 1, so that the distribution may stay below by as much more.
TEST(Standings, BetweenEqualSidesPIsUniformAndTheIntervalHoldsZero) {
  const EqualLeagues leagues;
  for (const auto& p : {leagues.p, leagues.tail}) {
    EXPECT_LT(FromUniform(p).above, 0.107);
    EXPECT_LT(FromUniform(p).below, 0.107 + 0.07);
  }
  // 200 leagues have a standard error of 1.5 %.
  EXPECT_NEAR(leagues.held / 200.0, 0.95, 0.04);
  EXPECT_NEAR(leagues.heldByT / 200.0, 0.95, 0.04);
}

}  // namespace
}  // namespace kelpie::league
