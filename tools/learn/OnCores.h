// SPDX-License-Identifier: Apache-2.0
// Independent trials on as many cores as there are. What comes out does not depend on how many.
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace kelpie::learn {

// one(i) for each i below `count`, in any order. What it throws comes out here.
template <class One>
void onCores(std::size_t count, One&& one) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) one(i);
  };
  std::vector<std::future<void>> workers;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t w = 0; w < std::min(cores, count); ++w)
    workers.push_back(std::async(std::launch::async, work));
  for (auto& worker : workers) worker.get();
}

}  // namespace kelpie::learn
