// SPDX-License-Identifier: Apache-2.0
// Whole matches of a team against itself: goals, own goals, balls out, how long the ball was
// contested, and what the referee called.
#include <algorithm>
#include <map>
#include <string>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 600.0;
constexpr double kAtBall = 30.0;  // cm from the neck base

struct Found {
  int goals = 0, ownGoals = 0, outs = 0;
  Values goalsOfMatch;
  Share contested;  // of the time in play, by robots of both teams
  std::map<std::string, int> calls;
};

bool contested(const sim::TruthFrame& truth) {
  bool at[2] = {false, false};
  for (const sim::RobotTruth& robot : truth.robots)
    if (distance(robot.pose.position, truth.ball) < kAtBall)
      at[robot.team == TeamColour::red ? 0 : 1] = true;
  return at[0] && at[1];
}

void judgeCalls(const TeamMatch& match, Found& found) {
  for (const sim::MatchEvent& event : match.events) {
    if (event.kind == sim::EventKind::goal) {
      ++found.goals;
      found.ownGoals += isOwnGoal(event) ? 1 : 0;
    }
    found.outs += event.kind == sim::EventKind::out ? 1 : 0;
    if (event.kind == sim::EventKind::penalty || event.kind == sim::EventKind::stuck ||
        event.kind == sim::EventKind::placed)
      ++found.calls[std::string(event.reason.view())];
  }
}

void judgeTime(const TeamMatch& match, Found& found) {
  bool inPlay = false;
  auto event = match.events.begin();
  for (const sim::TruthFrame& truth : match.truth) {
    for (; event != match.events.end() && event->time.us <= truth.time.us; ++event)
      inPlay = event->kind == sim::EventKind::play ||
               (inPlay && event->kind != sim::EventKind::goal &&
                event->kind != sim::EventKind::half && event->kind != sim::EventKind::end);
    if (inPlay) found.contested.count(contested(truth));
  }
}

Expected<Json> matchCalls(const Request& request) {
  Found found;
  const auto judge = [&](const cli::SessionResult& result, const TeamMatch& match) {
    judgeCalls(match, found);
    judgeTime(match, found);
    found.goalsOfMatch.push_back(static_cast<double>(result.goals.size() + result.ownGoals.size()));
  };
  const Status played = playFours(request, {kSeconds, Kept::world}, judge);
  if (!played) return Error{played.error()};
  Json calls = Json::object();
  for (const auto& [reason, count] : found.calls) calls[reason] = ratio(count, request.trials);
  return Json{{"goals_per_match", mean(found.goalsOfMatch)},
              {"own_goals_share", ratio(found.ownGoals, found.goals)},
              {"outs_per_match", ratio(found.outs, request.trials)},
              {"contested_share", found.contested.value()},
              {"calls_per_match", calls}};
}

const Registration kMatchCalls("match",
                               "whole matches of a team against itself: goals, outs, calls",
                               {Option::trials, Option::seed, Option::randomised, Option::params,
                                Option::fast},
                               4, matchCalls);

}  // namespace
}  // namespace kelpie::experiments
