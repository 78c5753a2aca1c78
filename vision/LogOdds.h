// SPDX-License-Identifier: Apache-2.0
// Facts that each add to the log odds of something, as a logistic regression finds them: a table of
// which fact, from which value on, and how much. Facts are taken as independent.
#pragma once

#include <array>
#include <cstddef>

namespace kelpie::vision {

enum class Range { any, near, far };  // where a fact counts

template <typename Facts>
struct Weight {
  double Facts::*fact;
  double least;    // of the fact, for it to count
  double logOdds;  // that it adds then
  Range range = Range::any;
};

template <typename Facts, std::size_t N>
double logOdds(double prior, const std::array<Weight<Facts>, N>& weights, const Facts& facts,
               bool near) {
  double sum = prior;
  for (const Weight<Facts>& w : weights) {
    const bool applies = w.range == Range::any || near == (w.range == Range::near);
    if (applies && facts.*w.fact >= w.least) sum += w.logOdds;
  }
  return sum;
}

}  // namespace kelpie::vision
