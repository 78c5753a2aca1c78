// SPDX-License-Identifier: Apache-2.0
// Matches that are drawn, not played: goals by Poisson, each side with as many on average as it is
// strong. The same match gives the same result.
#pragma once

#include <functional>
#include <map>

#include "robot/core/Random.h"
#include "tools/league/Schedule.h"

namespace kelpie::league {

struct RandomPlay {
  std::map<std::string, double> strength;  // goals a match; 1.5 where none is given
  double redAdvantage = 0.0;               // goals a match more for red

  MatchResult operator()(const LeagueMatch& match) const {
    const std::hash<std::string> hash;
    Random random(match.seed * 1000003 + hash(match.red) + 31 * hash(match.blue));
    MatchResult result;
    result.redGoals = poisson(random, strengthOf(match.red) + redAdvantage);
    result.blueGoals = poisson(random, strengthOf(match.blue));
    result.seconds = 60.0 * match.minutes;
    return result;
  }

 private:
  double strengthOf(const std::string& side) const {
    const auto found = strength.find(side);
    return found == strength.end() ? 1.5 : found->second;
  }

  // Knuth's: how many uniform draws until their product is below exp(-mean).
  static int poisson(Random& random, double mean) {
    int count = 0;
    for (double product = random.uniform(); product > maths::exp(-mean); ++count)
      product *= random.uniform();
    return count;
  }
};

// All of it, without a journal.
inline LeagueRecord playedLeague(const LeaguePlan& plan, const Play& play) {
  LeagueRecord league{plan, {}};
  for (const ScheduledMatch& scheduled : scheduleOf(plan))
    league.results.emplace_back(play(scheduled.match));
  return league;
}

inline LeaguePlan smallPlan() {
  LeaguePlan plan;
  plan.sides = {"a", "b", "c"};
  plan.matchesAPair = 4;
  plan.seed = 7;
  plan.about = "a test";
  return plan;
}

}  // namespace kelpie::league
