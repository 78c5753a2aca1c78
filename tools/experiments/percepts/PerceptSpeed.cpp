// SPDX-License-Identifier: Apache-2.0
// How fast matches of percepts (tools/percepts) are played: simulated seconds for each second that
// the one process of a match of 4v4 takes of a processor, its start and the folder of the match
// with it. No robot keeps a log. Other programs count only as far as they take the caches.
#include <sys/resource.h>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/session/Session.h"
#include "tools/session/Teams.h"

namespace kelpie::experiments {
namespace {

constexpr double kMinutes = 2.0;  // of play

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Of the processor, by child processes that have ended.
double childSeconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
}

Expected<cli::SessionOptions> sessionOf(const Request& request, int number) {
  cli::SessionOptions session;
  const auto plan = cli::teamPlan("4v4");
  if (!plan) return Error{plan.error()};
  const Status used = cli::useTeams(*plan, session);
  if (!used) return Error{used.error()};
  session.seed = request.seed + static_cast<std::uint64_t>(number);
  session.seconds = 60.0 * (request.minutes > 0.0 ? request.minutes : kMinutes);
  session.goals = 99;
  session.physical = false;
  session.percepts = true;
  return session;
}

Expected<Json> perceptSpeed(const Request& request) {
  Values speeds;
  for (int i = 0; i < request.trials; ++i) {
    const auto session = sessionOf(request, i);
    if (!session) return Error{session.error()};
    const double before = childSeconds();
    cli::SessionTalk quiet;
    quiet.line = [](const std::string&) {};
    const cli::SessionResult result = cli::runSession(*session, quiet);
    if (!result.trouble.empty()) return Error{result.trouble};
    speeds.push_back(ratio(result.seconds, childSeconds() - before));
    if (request.progress) request.progress(i + 1, request.trials);
  }
  return Json{{"percept_speed", percentile(speeds, 0.5)},
              {"percept_speed_best", percentile(speeds, 1.0)}};
}

const Registration kPerceptSpeed("percept-speed",
                                 "simulated seconds per processor second of a match of percepts",
                                 {Option::trials, Option::seed, Option::minutes}, 3, perceptSpeed);

}  // namespace
}  // namespace kelpie::experiments
