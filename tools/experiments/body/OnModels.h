// SPDX-License-Identifier: Apache-2.0
// The same on as many varied physical models as there are trials, on as many cores as there are.
#pragma once

#include <atomic>
#include <future>
#include <thread>
#include <vector>

#include "tools/experiments/harness/Experiment.h"
#include "tools/learn/walk/WalkTrial.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::experiments {

// one(physics, seed) -> Result; the results are in the order of the seeds.
template <class Result, class One>
std::vector<Result> onModels(const Request& request, One&& one) {
  std::vector<Result> results(static_cast<std::size_t>(request.trials));
  std::atomic<std::size_t> next{0};
  std::atomic<int> done{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++) {
      const std::uint64_t seed = request.seed + i;
      results[i] = one(sim::varied({}, seed), seed);
      ++done;
    }
  };
  std::vector<std::future<void>> workers;
  for (unsigned w = 0; w < std::max(1U, std::thread::hardware_concurrency()); ++w)
    workers.push_back(std::async(std::launch::async, work));
  for (auto& worker : workers) worker.get();
  if (request.progress) request.progress(done, request.trials);
  return results;
}

}  // namespace kelpie::experiments
