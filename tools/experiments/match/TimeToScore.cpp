// SPDX-License-Identifier: Apache-2.0
// How soon a robot that is alone on the field scores: one forward (--a) and the ball, each
// anywhere, before the open goal. Every trial is a match of its own seed, which draws both places.
// With --fast from percepts, else from images on a physical body.
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Matches.h"
#include "tools/session/Teams.h"

namespace kelpie::experiments {
namespace {

constexpr double kLimit = 60.0;  // simulated seconds, of who does not score

Status alone(const Request& request, cli::SessionOptions& session) {
  const Status used = cli::useTeams({1, 0, sideOr(request.sideA, "kelpie"), ""}, session);
  if (!used) return used;
  session.scenario = "empty-goal";
  session.rules = false;
  session.seconds = kLimit;
  session.percepts = request.fast;
  return Done{};
}

Expected<Json> timeToScore(const Request& request) {
  cli::SessionOptions first = sessionOf(request, trialOf(request, 0));
  const Status staged = alone(request, first);
  if (!staged) return Error{staged.error()};
  Share scored;
  Values times;
  Matches matches;
  matches.count = request.trials;
  matches.session = [&](int number) {
    cli::SessionOptions session = sessionOf(request, trialOf(request, number));
    if (!alone(request, session)) session.pycode = request.sideA;  // it was asked before
    return session;
  };
  matches.judge = [&](int, const cli::SessionResult& result, const Played&) {
    const bool goal = !result.goals.empty() && result.goals[0] <= kLimit;
    scored.count(goal);
    times.push_back(goal ? result.goals[0] : kLimit);
  };
  const Status played = playMatches(request, matches);
  if (!played) return Error{played.error()};
  return Json{{"goals", scored.value()},
              {"median_s", percentile(times, 0.5)},
              {"p90_s", percentile(times, 0.9)}};
}

const Registration kTimeToScore("time-to-score",
                                "a robot alone (--a), it and the ball anywhere: s to the goal",
                                {Option::trials, Option::seed, Option::fast, Option::side}, 100,
                                timeToScore);

}  // namespace
}  // namespace kelpie::experiments
