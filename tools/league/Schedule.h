// SPDX-License-Identifier: Apache-2.0
// What a league is: sides that play each other, and its matches in order. Each pair of sides plays
// every seed twice with colours exchanged, so that neither the draw nor the colour favours one of
// them; the two matches of a seed together are one observation (Standings.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::league {

// One match: which side wears which colour.
struct LeagueMatch {
  std::string red;
  std::string blue;
  std::uint64_t seed = 1;
  double minutes = 10.0;
  bool fast = false;  // kinematic bodies
};

struct MatchResult {
  int redGoals = 0;      // that count for red, those that blue shot into its own goal included
  int blueGoals = 0;     // that count for blue, so
  int redOwnGoals = 0;   // of blueGoals those that red shot itself
  int blueOwnGoals = 0;  // of redGoals those that blue shot itself
  int outs = 0;
  double seconds = 0.0;  // simulated
  std::string trouble;   // one line: why the rest means nothing; empty when it was played out
};

// Plays one match with processes of its own; called by several threads at once. The same match
// gives the same result. A match that was cut short, as by an interrupt, must say so in `trouble`.
using Play = std::function<MatchResult(const LeagueMatch&)>;

struct LeaguePlan {
  std::vector<std::string> sides;  // names: printable ASCII, at most kLongestName characters
  std::string reference;           // one of the sides, which alone the others play; empty: all play
  int matchesAPair = 20;           // even: half as many seeds
  std::uint64_t seed = 1;          // the first; every pair plays the same ones
  double minutes = 10.0;           // of a match
  bool fast = false;               // kinematic bodies
  // Whatever else the results depend on: the program's commit, the sides' scripts and parameters.
  // A league is the same only when this is the same.
  std::string about;
};

constexpr std::size_t kLongestName = 40;

// Which of the plan's sides meet, as indices, the earlier side first.
struct Pairing {
  std::size_t first = 0;
  std::size_t second = 0;
};
std::vector<Pairing> pairingsOf(const LeaguePlan& plan);

// Why such a league cannot be played, in one line.
Status checkPlan(const LeaguePlan& plan);

// A match's place in the plan.
struct ScheduledMatch {
  std::size_t pairing = 0;  // index into pairingsOf()
  int draw = 0;             // which seed, from 0
  bool exchanged = false;   // the pairing's second side is red
  LeagueMatch match;
};

// All matches in the order in which they are begun: by seed, then by pair, then by colours, so that
// a league that is cut short has played as much of every pair. The plan has passed checkPlan().
std::vector<ScheduledMatch> scheduleOf(const LeaguePlan& plan);

// By the match's number in scheduleOf(); nothing where it is still to be played. A result with
// `trouble` is void: it has been tried twice.
using Results = std::vector<std::optional<MatchResult>>;

struct LeagueRecord {
  LeaguePlan plan;
  Results results;
};

}  // namespace kelpie::league
