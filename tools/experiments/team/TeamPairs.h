// SPDX-License-Identifier: Apache-2.0
// Two teams of four that differ in one word of their parameters: each seed is played twice, the
// second time with sides exchanged, and both matches together are one difference in goals.
#pragma once

#include <array>
#include <string>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Matches.h"

namespace kelpie::experiments {

struct Side {
  const char* name = "";   // as the figures call it
  const char* param = "";  // for --set, of all its robots
};
using TwoSides = std::array<Side, 2>;

struct SideTally {
  int goals = 0;  // own goals of the others among them
  int ownGoals = 0;
  int outs = 0;  // of balls that it touched last

  void add(const SideTally& other);
};

// Of a match by the rules.
SideTally tallyOf(const Played& played, TeamColour team);

// Of several pairs.
struct PairsTally {
  std::array<SideTally, 2> sides;
  Values differences;  // goals a match that the first is ahead by; one a seed
};
Json figuresOf(const TwoSides& sides, const PairsTally& tally);

// The colour that a side plays in, in the first or in the second match of a seed.
TeamColour colourOf(std::size_t side, int match);
// Gives the word to the robots of that team.
void giveParam(const char* param, TeamColour team, cli::SessionOptions& session);

// A pair for each trial, of the request's minutes each match, or of four.
Expected<Json> comparePairs(const Request& request, const TwoSides& sides);

}  // namespace kelpie::experiments
