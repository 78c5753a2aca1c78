// SPDX-License-Identifier: Apache-2.0
// What a search (Search.h) may change, and how it goes about it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kelpie::learn {

struct SearchSpace {
  std::vector<std::string> names;
  std::vector<double> min;
  std::vector<double> max;
  std::vector<double> start;  // moved inside
};

struct SearchPlan {
  int trials = 600;
  int population = 0;   // of one generation; 0: by the count of numbers
  double spread = 0.2;  // the first standard deviation, share of each number's range
  std::uint32_t seed = 1;
  std::string journal;  // a file; empty: none
  std::string trial;    // what else a gain depends on, in words: a journal is of that alone
};

}  // namespace kelpie::learn
