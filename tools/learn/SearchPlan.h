// SPDX-License-Identifier: Apache-2.0
// What a search (Search.h) may change, and how it goes about it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kelpie::learn {

struct SearchSpace {
  std::vector<std::string> names;
  std::vector<double> least;
  std::vector<double> most;
  std::vector<double> start;  // moved inside
};

// CRS keeps the best points from everywhere; CMA-ES follows a valley of many numbers: a kick of 27
// numbers gained 0.73 after 400 trials, by CRS 0.48.
enum class SearchMethod : std::uint8_t { crs, cma };

struct SearchPlan {
  SearchMethod method = SearchMethod::crs;
  int trials = 600;
  int population = 40;  // 0, of CMA-ES only: by the count of numbers
  double spread = 0.2;  // of CMA-ES: the first standard deviation, share of each number's range
  std::uint32_t seed = 1;
  std::string journal;  // a file; empty: none
};

}  // namespace kelpie::learn
