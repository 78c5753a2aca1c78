// SPDX-License-Identifier: Apache-2.0
// The spine's own measure: from pixels to joints to a goal. Every trial is a match of its own seed
// (seed, seed + 1, ...), which draws start pose, ball, slip, noise and the robot's colour shift.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "tools/cli/Process.h"
#include "tools/cli/Session.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"

namespace kelpie::experiments {
namespace {

constexpr double kLimit = 60.0;  // simulated seconds

struct Trials {
  std::vector<cli::SessionResult> results;
  std::string error;  // of the first trial that broke
};

Trials playAll(const Request& request) {
  cli::catchInterrupts();  // so that no match leaves its folder behind
  Trials all;
  all.results.resize(static_cast<std::size_t>(request.trials));
  std::atomic<int> next{0};
  std::atomic<int> done{0};
  std::mutex mutex;
  const auto worker = [&] {
    for (int i = next++; i < request.trials && !cli::interrupted(); i = next++) {
      cli::SessionOptions session;
      session.seed = trialOf(request, i).seed;
      session.seconds = kLimit;
      session.unlike = request.unlike;
      session.physical = !request.fast;
      const cli::SessionResult result = cli::runSession(session, {});
      const std::lock_guard<std::mutex> lock(mutex);
      all.results[static_cast<std::size_t>(i)] = result;
      if (!result.trouble.empty() && all.error.empty())
        all.error = "seed " + std::to_string(session.seed) + ": " + result.trouble;
      if (request.progress) request.progress(++done, request.trials);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(worker);
  for (auto& thread : workers) thread.join();
  if (cli::interrupted()) all.error = "interrupted";
  return all;
}

Expected<Json> scoreEmptyGoal(const Request& request) {
  const Trials all = playAll(request);
  if (!all.error.empty()) return Error{all.error};
  Values times;
  Json trials = Json::array();
  Share scored;
  int ownGoals = 0;
  for (std::size_t i = 0; i < all.results.size(); ++i) {
    const auto& result = all.results[i];
    const bool goal = !result.goals.empty() && result.goals[0] <= kLimit;
    scored.count(goal);
    ownGoals += static_cast<int>(result.ownGoals.size());
    times.push_back(goal ? result.goals[0] : kLimit);
    trials.push_back({{"seed", request.seed + i},
                      {"goal", goal ? 1 : 0},
                      {"seconds_s", times.back()},
                      {"outs", result.outs}});
  }
  return Json{{"goals_rate", scored.value()},
              {"median_s", percentile(times, 0.5)},
              {"p90_s", percentile(times, 0.9)},
              {"own_goals", ownGoals},
              {"each", trials}};
}

const Registration kScoreEmptyGoal(
    "score-empty-goal", "one robot against an empty goal: share of goals within 60 s, time",
    {Option::trials, Option::seed, Option::unlike, Option::fast}, 20, scoreEmptyGoal);

}  // namespace
}  // namespace kelpie::experiments
