// SPDX-License-Identifier: Apache-2.0
// The trials of one search in a file: the search's own line, then of each trial the point's numbers
// and its gain. A search that is begun again takes from it what it tried before.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/learn/SearchPlan.h"

namespace kelpie::learn {

class SearchJournal {
 public:
  // Errors: a journal of another search, or one that cannot be written.
  Status open(const SearchSpace& space, const SearchPlan& plan);
  // The gain of trial number i, when it is known and was of that point.
  const double* find(std::size_t i, const std::vector<double>& point) const;
  // Writes trial number i, which was not known; what was known from there on was of other points.
  Status add(std::size_t i, const std::vector<double>& point, double gain);

 private:
  Status rewrite();

  std::string path_;
  std::string head_;
  std::vector<std::vector<double>> known_;
  std::ofstream out_;
};

}  // namespace kelpie::learn
