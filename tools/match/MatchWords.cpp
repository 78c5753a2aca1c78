// SPDX-License-Identifier: Apache-2.0
#include "tools/match/MatchWords.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kelpie::match {
namespace {

std::string noteOf(const LogMap& notes, const char* key) {
  const auto found = notes.find(key);
  return found == notes.end() ? std::string() : found->second;
}

const char* countWord(int count) {
  constexpr std::array<const char*, 5> kWords = {"No robot", "One robot", "Two robots",
                                                 "Three robots", "Four robots"};
  return kWords[static_cast<std::size_t>(count < 0 || count > 4 ? 0 : count)];
}

std::string sidesOf(const MatchFacts& facts) {
  const bool red = facts.team == TeamColour::red;
  const int own = red ? facts.reds : facts.blues;
  const int other = red ? facts.blues : facts.reds;
  if (own + other == 0) return "A recording of one robot";
  std::string words = countWord(own);
  if (other == 0) return words + " and an empty goal";
  const char* const against = countWord(other);
  return words + " against " + static_cast<char>(against[0] - 'A' + 'a') +
         std::string(against + 1, std::string(against).find(' ') - 1);
}

const char* colourOf(TeamColour team) { return team == TeamColour::red ? "red" : "blue"; }

}  // namespace

MatchFacts factsOf(const LogMap& notes, TeamColour team, int player) {
  MatchFacts facts;
  facts.red = noteOf(notes, "red");
  facts.blue = noteOf(notes, "blue");
  facts.seed = noteOf(notes, "seed");
  facts.team = team;
  facts.player = player;
  return facts;
}

void add(const Moment& moment, MatchFacts& facts) {
  facts.seconds = moment.input.time.seconds();
  if (!moment.truth.present) return;
  facts.scored = true;
  facts.reds = facts.blues = 0;
  for (const TrueRobot& robot : moment.truth.robots)
    ++(robot.team == TeamColour::red ? facts.reds : facts.blues);
}

void score(const std::vector<sim::MatchEvent>& events, TimeUs until, MatchFacts& facts) {
  facts.redScore = facts.blueScore = 0;
  for (const sim::MatchEvent& event : events)
    if (event.kind == sim::EventKind::goal && event.time <= until)
      ++(event.team == TeamColour::red ? facts.redScore : facts.blueScore);
}

std::string nameOf(const MatchFacts& facts, TeamColour team) {
  const std::string& name = team == TeamColour::red ? facts.red : facts.blue;
  if (!name.empty()) return name;
  const int robots = team == TeamColour::red ? facts.reds : facts.blues;
  return facts.scored && robots == 0 ? "empty goal" : colourOf(team);
}

std::string scoreOf(const MatchFacts& facts) {
  return facts.scored ? fmt::format("{} : {}", facts.redScore, facts.blueScore) : "-";
}

std::string subtitleOf(const MatchFacts& facts) {
  const std::string seed = facts.seed.empty() ? "" : " · seed " + facts.seed;
  return fmt::format("{} · {}{}", sidesOf(facts), clockOf(facts.seconds), seed);
}

std::string attackOf(const MatchFacts& facts) {
  const bool red = facts.team == TeamColour::red;
  return fmt::format("{} attacks the {} goal", red ? "Red" : "Blue", red ? "blue" : "yellow");
}

std::string clockOf(double seconds) {
  const double whole = std::max(0.0, seconds);
  const int minutes = static_cast<int>((whole + 0.05) / 60.0);
  return fmt::format("{}:{:04.1f}", minutes, std::max(0.0, whole - 60.0 * minutes));
}

}  // namespace kelpie::match
