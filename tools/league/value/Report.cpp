// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/Report.h"

#include <fmt/core.h>

#include <iterator>

#include "tools/match/Decisions.h"

namespace kelpie::value {
namespace {

constexpr TeamColour kTeams[] = {TeamColour::red, TeamColour::blue};

const char* nameOf(TeamColour team) { return team == TeamColour::red ? "red" : "blue"; }

void add(const Doing& doing, Worth& worth) {
  worth.lasts += doing.lasts;
  worth.gained += doing.gained;
  if (doing.gained > 0.0) worth.won += doing.gained;
}

// What the last decision of the frame chose, from the tree's on.
std::string leafOf(const Trace& trace) {
  std::string leaf;
  for (const TraceStep& step : trace)
    if (step.layer == TraceLayer::decision) leaf = std::string(step.branch.view());
  return leaf;
}

std::string tableOf(const char* what, const Worths& worths) {
  std::string text =
      fmt::format("\n{:24} {:>8} {:>8} {:>8} {:>8}\n", what, "s", "won", "lost", "gained");
  for (const auto& [who, worth] : worths)
    text += fmt::format("{:4} {:19} {:8.1f} {:8.3f} {:8.3f} {:8.3f}\n", nameOf(who.first),
                        who.second, worth.lasts, worth.won, worth.won - worth.gained, worth.gained);
  return text;
}

}  // namespace

cli::Json jsonOf(const MatchFigures& figures) {
  cli::Json json{{"value", figures.value()}};
  for (const TeamColour team : kTeams) {
    const TeamFigures& of = figures.of(team);
    const std::string name = nameOf(team);
    json[name + "_value"] = of.value;
    json[name + "_shots"] = of.shots;
    json[name + "_xg"] = of.shotGoals;
  }
  return json;
}

std::string lineOf(const MatchFigures& figures) {
  const TeamFigures& red = figures.of(TeamColour::red);
  const TeamFigures& blue = figures.of(TeamColour::blue);
  return fmt::format("expected goals {:.2f} : {:.2f}, shots {} : {} with {:.2f} : {:.2f} of them",
                     red.value, blue.value, red.shots, blue.shots, red.shotGoals, blue.shotGoals);
}

Status Leaves::read(const std::string& log) {
  std::map<double, std::string> played;
  constexpr double kEver = 1e9;
  const auto read = match::readDecisions(log, {0.0, kEver}, [&](const match::Decision& decision) {
    const std::string leaf = leafOf(decision.command.trace);
    if (played.empty() || played.rbegin()->second != leaf) played[decision.seconds] = leaf;
  });
  if (!read) return Error{read.error()};
  played_[{read->team, read->player}] = std::move(played);
  return Done{};
}

std::string Leaves::at(const Doing& doing) const {
  const auto robot = played_.find({doing.team, doing.player});
  if (robot == played_.end()) return "";
  const auto after = robot->second.upper_bound(doing.seconds);
  return after == robot->second.begin() ? "" : std::prev(after)->second;
}

void Report::add(const MatchFigures& figures, const Leaves& leaves) {
  ++matches_;
  sum_.played += figures.played;
  for (const TeamColour team : kTeams) {
    const TeamFigures& from = figures.of(team);
    TeamFigures& to = sum_.teams[static_cast<std::size_t>(team)];
    to.goals += from.goals;
    to.value += from.value;
    to.shots += from.shots;
    to.shotGoals += from.shotGoals;
  }
  for (const Doing& doing : figures.doings) {
    value::add(doing, robots_[{doing.team, std::to_string(doing.player)}]);
    const std::string leaf = leaves.at(doing);
    if (!leaf.empty()) value::add(doing, leaves_[{doing.team, leaf}]);
  }
}

std::string Report::text() const {
  std::string text = fmt::format(
      "{} matches, {:.1f} min of play\n\n{:6} {:>6} {:>9} {:>9} {:>6} {:>9}\n", matches_,
      sum_.played / 60.0, "team", "goals", "expected", "against", "shots", "of shots");
  for (const TeamColour team : kTeams) {
    const TeamFigures& own = sum_.of(team);
    const TeamFigures& other =
        sum_.of(team == TeamColour::red ? TeamColour::blue : TeamColour::red);
    text += fmt::format("{:6} {:6} {:9.2f} {:9.2f} {:6} {:9.2f}\n", nameOf(team), own.goals,
                        own.value, other.value, own.shots, own.shotGoals);
  }
  text += tableOf("value by robot", robots_);
  if (!leaves_.empty()) text += tableOf("value by leaf", leaves_);
  return text;
}

}  // namespace kelpie::value
