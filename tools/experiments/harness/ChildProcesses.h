// SPDX-License-Identifier: Apache-2.0
// Runs trials in child processes, as many at a time as there are cores: a process can hold only one
// Python interpreter, so matches with behaviours cannot share one. A child that dies fails its
// trial. What a trial found is a struct with a field list (Record.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Record.h"
#include "tools/experiments/harness/Trials.h"

namespace kelpie::experiments {

using Job = std::function<Expected<Json>(int number)>;

// The answers in the order of their numbers, or the error of the first job that failed.
Expected<std::vector<Json>> runInChildProcesses(
    int jobs, const Job& job, const std::function<void(int done, int all)>& progress);

// Calls one(trial) for every trial, which answers with an Expected<Result>. All results in the
// order of the trials, or the seed and the error of one that failed.
template <class One>
auto trialsInChildProcesses(const Request& request, One&& one) {
  using Result = std::decay_t<decltype(*one(Trial{}))>;
  const auto job = [&](int number) -> Expected<Json> {
    const Trial trial = trialOf(request, number);
    const auto result = one(trial);
    if (!result) return Error{"seed " + std::to_string(trial.seed) + ": " + result.error()};
    return toJson(*result);
  };
  const auto answers = runInChildProcesses(request.trials, job, request.progress);
  if (!answers) return Expected<std::vector<Result>>(Error{answers.error()});
  std::vector<Result> results(answers->size());
  for (std::size_t i = 0; i < results.size(); ++i) fromJson((*answers)[i], results[i]);
  return Expected<std::vector<Result>>(std::move(results));
}

}  // namespace kelpie::experiments
