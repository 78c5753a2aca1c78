// SPDX-License-Identifier: Apache-2.0
// The statistics of which the figures are made. Of no values every one of them is 0.
#pragma once

#include <vector>

#include "robot/core/fields/Fields.h"
#include "tools/cli/Figures.h"

namespace kelpie::experiments {

using cli::percentile;
using Values = std::vector<double>;

double sum(const Values& values);
double mean(const Values& values);
double rms(const Values& values);                // root of the mean square
double standardDeviation(const Values& values);  // of the values themselves, not of a sample's mean
double shareAbove(const Values& values, double limit);
double shareUpTo(const Values& values, double limit);
double ratio(double part, double whole);

void append(const Values& values, Values& to);

// The share of hits among all that were counted.
struct Share {
  int hits = 0;
  int all = 0;

  void count(bool hit) {
    ++all;
    hits += hit ? 1 : 0;
  }
  void add(const Share& other) {
    hits += other.hits;
    all += other.all;
  }
  double value() const { return ratio(hits, all); }

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("hits", &Share::hits), field("all", &Share::all));
  }
};

}  // namespace kelpie::experiments
