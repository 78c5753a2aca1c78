// SPDX-License-Identifier: Apache-2.0
// Log odds of something as a sum of curves over plain facts, as a logistic regression finds them
// (kelpie evaluate doubts). Facts are taken as independent.
#pragma once

#include <array>
#include <cstddef>

namespace kelpie::vision {

// Straight between six values of the fact, constant below and above them. A fact of fewer values
// repeats the last.
template <typename Facts>
struct Curve {
  static constexpr std::size_t kKnots = 6;
  double Facts::*fact;
  std::array<double, kKnots> at;  // rising
  std::array<double, kKnots> logOdds;

  double operator()(const Facts& facts) const {
    const double value = facts.*fact;
    if (!(value > at[0])) return logOdds[0];
    for (std::size_t i = 1; i < kKnots; ++i) {
      if (value >= at[i]) continue;
      const double share = (value - at[i - 1]) / (at[i] - at[i - 1]);
      return logOdds[i - 1] + share * (logOdds[i] - logOdds[i - 1]);
    }
    return logOdds[kKnots - 1];
  }
};

template <typename Facts, std::size_t N>
double logOdds(double prior, const std::array<Curve<Facts>, N>& curves, const Facts& facts) {
  double sum = prior;
  for (const Curve<Facts>& curve : curves) sum += curve(facts);
  return sum;
}

}  // namespace kelpie::vision
