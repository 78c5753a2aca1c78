// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/harness/Statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kelpie::experiments {
namespace {

double sumOfSquares(const Values& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return sum;
}

double count(const Values& values) { return static_cast<double>(values.size()); }

}  // namespace

double sum(const Values& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double mean(const Values& values) { return ratio(sum(values), count(values)); }

double rms(const Values& values) { return std::sqrt(ratio(sumOfSquares(values), count(values))); }

double standardDeviation(const Values& values) {
  const double middle = mean(values);
  const double variance = ratio(sumOfSquares(values), count(values)) - middle * middle;
  return std::sqrt(std::fmax(0.0, variance));
}

double shareAbove(const Values& values, double limit) {
  const auto above =
      std::count_if(values.begin(), values.end(), [limit](double v) { return v > limit; });
  return ratio(static_cast<double>(above), count(values));
}

double shareUpTo(const Values& values, double limit) {
  const auto within =
      std::count_if(values.begin(), values.end(), [limit](double v) { return v <= limit; });
  return ratio(static_cast<double>(within), count(values));
}

double ratio(double part, double whole) { return whole != 0.0 ? part / whole : 0.0; }

void append(const Values& values, Values& to) { to.insert(to.end(), values.begin(), values.end()); }

}  // namespace kelpie::experiments
