// SPDX-License-Identifier: Apache-2.0
// Runs jobs in child processes, as many at a time as there are cores: a process can hold only one
// interpreter, so matches with behaviours cannot share one. A child that dies fails its job.
#pragma once

#include <functional>
#include <vector>

#include "tools/experiments/Experiment.h"

namespace kelpie::experiments {

using Job = std::function<Expected<Json>(int number)>;

// The answers in the order of their numbers, or the error of the first job that failed.
Expected<std::vector<Json>> runApart(int jobs, const Job& job,
                                     const std::function<void(int done, int all)>& progress);

}  // namespace kelpie::experiments
