// SPDX-License-Identifier: Apache-2.0
// What a league's results say of its sides and pairs. Only seeds of which a pair has played both
// matches to their end count, here and in every column, so that no side gains by its colours; what
// is left out is reported. Goal differences are in goals a match: the mean of a seed's two matches.
#pragma once

#include <string>
#include <vector>

#include "tools/league/PairedStatistics.h"
#include "tools/league/Schedule.h"

namespace kelpie::league {

constexpr int kPointsOfWin = 3;
constexpr int kPointsOfDraw = 1;

struct Score {
  int matches = 0;
  int wins = 0;
  int draws = 0;
  int losses = 0;
  int goals = 0;     // that count for it
  int against = 0;   // that count for the others
  int ownGoals = 0;  // of `against`, shot by itself

  int points() const { return kPointsOfWin * wins + kPointsOfDraw * draws; }
};

struct SideStanding {
  std::string name;
  Score score;
  // Of one seed: the mean over the pairs that have played it, since what all of them play by one
  // seed may go together.
  PairedStatistics difference;
};

struct PairStanding {
  std::string first;
  std::string second;
  Score score;                  // of the first
  PairedStatistics difference;  // first less second, one for each seed
};

struct Standings {
  LeaguePlan plan;
  std::vector<SideStanding> sides;  // by points, then difference, then goals, then name
  std::vector<PairStanding> pairs;  // in the order of the schedule
  std::size_t matches = 0;          // of the whole league
  std::size_t counted = 0;
  std::size_t voids = 0;
  std::size_t unpaired = 0;           // played, but the seed's other match is void or missing
  std::vector<std::string> troubles;  // one line for each void match

  std::size_t left() const { return matches - counted - voids - unpaired; }
};

Standings standingsOf(const LeagueRecord& league, const Resampling& params = {});

}  // namespace kelpie::league
