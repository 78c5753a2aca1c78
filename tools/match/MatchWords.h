// SPDX-License-Identifier: Apache-2.0
// What stands over the pictures and films of a match, from what its log knows. Pure: the same facts
// give the same words. What the log does not know is left out.
#pragma once

#include <string>
#include <vector>

#include "robot/core/log/LogFormat.h"
#include "tools/match/Draw.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::match {

struct MatchFacts {
  std::string red;   // whose team, in a word or two; empty: nobody says
  std::string blue;  // so
  int reds = 0;      // robots
  int blues = 0;
  bool scored = false;  // the world tells of it: a recording of a robot has no score
  int redScore = 0;
  int blueScore = 0;
  std::string seed;  // empty: nobody says
  double seconds = 0.0;
  TeamColour team = TeamColour::red;  // of the robot whose log it is
  int player = 1;
};

MatchFacts factsOf(const LogMap& notes, TeamColour team, int player);
// Takes over what a moment tells: how many robots, the time.
void add(const Moment& moment, MatchFacts& facts);
// The goals that have fallen until then.
void score(const std::vector<sim::MatchEvent>& events, TimeUs until, MatchFacts& facts);

// "kelpie" and "empty goal", "red" where nobody says.
std::string nameOf(const MatchFacts& facts, TeamColour team);
// "1 : 0"; "-" between the names where there is no score.
std::string scoreOf(const MatchFacts& facts);
// "One robot against an empty goal · 29 s · seed 2"
std::string subtitleOf(const MatchFacts& facts);
// "Red 2's view: red attacks the blue goal."
std::string attackOf(const MatchFacts& facts);
// "0:29.3", "12:05.0"
std::string clockOf(double seconds);

}  // namespace kelpie::match
