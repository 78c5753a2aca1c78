// SPDX-License-Identifier: Apache-2.0
// Independent work on as many cores as there are. What comes out does not depend on how many.
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace kelpie::host {

// one(i) for each i below `count`, in any order. What it throws comes out here.
template <class One>
void onCores(std::size_t count, One&& one) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) one(i);
  };
  std::vector<std::future<void>> others;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t w = 1; w < std::min(cores, count); ++w)
    others.push_back(std::async(std::launch::async, work));
  work();
  for (auto& other : others) other.get();
}

}  // namespace kelpie::host
