// SPDX-License-Identifier: Apache-2.0
// The search for numbers that do something best, within bounds and from a seed, by CMA-ES of
// Debian's python3-cmaes; it follows a valley of many numbers: a kick of 27 numbers gained 0.73
// after 400 trials, by controlled random search (NLopt's CRS2) 0.48. Every trial is written into a
// journal; with the journal of a search that was broken off the same trials are taken from it, so
// that the search goes on where it was.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/learn/SearchPlan.h"

namespace kelpie::learn {

struct SearchResult {
  std::vector<double> best;
  double gain = 0.0;
  std::vector<double> gains;  // the best gain after each trial
  int replayed = 0;           // of them taken from the journal
};

// The gain of a point; greater is better, must be finite.
using Gain = std::function<double(const std::vector<double>&)>;
// Called after each trial: how many were made, and the best gain.
using Listener = std::function<void(int, double)>;

// Errors: a journal of another search, or one that cannot be written.
Expected<SearchResult> search(const SearchSpace& space, const SearchPlan& plan, const Gain& gain,
                              const Listener& listener);

}  // namespace kelpie::learn
