// SPDX-License-Identifier: Apache-2.0
// The spine's own measure: from pixels to joints to a goal. Every trial is a match of its own seed
// (seed, seed + 1, ...), which draws start pose, ball, slip, noise and the robot's colour shift;
// each is played twice, by a robot that may grab the ball and by one that may not.
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Matches.h"

namespace kelpie::experiments {
namespace {

constexpr double kLimit = 60.0;  // simulated seconds

using Results = std::vector<cli::SessionResult>;

Expected<Results> playAll(const Request& request, bool grab) {
  Results results(static_cast<std::size_t>(request.trials));
  Matches matches;
  matches.count = request.trials;
  matches.session = [&](int number) {
    cli::SessionOptions session = sessionOf(request, trialOf(request, number));
    session.seconds = kLimit;
    if (!grab) session.set = {"behaviour.task.grab=false"};
    return session;
  };
  matches.judge = [&](int number, const cli::SessionResult& result, const Played&) {
    results[static_cast<std::size_t>(number)] = result;
  };
  const Status played = playMatches(request, matches);
  if (!played) return Error{played.error()};
  return results;
}

struct Score {
  Share scored;
  Values times;
  int ownGoals = 0;
};

Score scoreOf(const Results& results) {
  Score score;
  for (const auto& result : results) {
    const bool goal = !result.goals.empty() && result.goals[0] <= kLimit;
    score.scored.count(goal);
    score.ownGoals += static_cast<int>(result.ownGoals.size());
    score.times.push_back(goal ? result.goals[0] : kLimit);
  }
  return score;
}

Json eachOf(const Request& request, const Results& results, const Score& score) {
  Json trials = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i)
    trials.push_back({{"seed", request.seed + i},
                      {"goal", score.times[i] < kLimit ? 1 : 0},
                      {"seconds_s", score.times[i]},
                      {"outs", results[i].outs}});
  return trials;
}

Expected<Json> scoreEmptyGoal(const Request& request) {
  const auto grabbing = playAll(request, true);
  if (!grabbing) return Error{grabbing.error()};
  const auto kicking = playAll(request, false);
  if (!kicking) return Error{kicking.error()};
  const Score with = scoreOf(*grabbing);
  const Score without = scoreOf(*kicking);
  return Json{{"goals_rate", with.scored.value()},
              {"median_s", percentile(with.times, 0.5)},
              {"p90_s", percentile(with.times, 0.9)},
              {"own_goals", with.ownGoals},
              {"goals_rate_no_grab", without.scored.value()},
              {"median_no_grab_s", percentile(without.times, 0.5)},
              {"p90_no_grab_s", percentile(without.times, 0.9)},
              {"own_goals_no_grab", without.ownGoals},
              {"each", eachOf(request, *grabbing, with)},
              {"each_no_grab", eachOf(request, *kicking, without)}};
}

const Registration kScoreEmptyGoal(
    "score-empty-goal", "a robot against an empty goal: goals in 60 s, time, with and without grab",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 20,
    scoreEmptyGoal);

}  // namespace
}  // namespace kelpie::experiments
