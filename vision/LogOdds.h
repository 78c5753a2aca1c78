// SPDX-License-Identifier: Apache-2.0
// Log odds of something as a sum of curves over plain facts, as a logistic regression finds them
// (kelpie evaluate doubts). Facts are taken as independent.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "robot/core/Maths.h"

namespace kelpie::vision {

// A fact that holds or does not.
inline double flag(bool set) { return set ? 1.0 : 0.0; }

// The log of a ratio as a fact, which beyond twenty times as large or small says nothing more.
inline double logOfRatio(double ratio) {
  constexpr double kMaxLog = 3.0;
  return maths::clamp(maths::log(ratio), -kMaxLog, kMaxLog);
}

// Where a value lies among rising knots: the one at or below it, and its share of the way to the
// next. Outside them it lies on the first or the last.
struct KnotPlace {
  std::size_t knot = 0;
  double share = 0.0;
};

template <typename Knots>
KnotPlace placeAmong(const Knots& at, double value) {
  if (at.empty() || !(value > at.front())) return {};
  if (value >= at.back()) return {at.size() - 1, 0.0};
  const auto next = std::upper_bound(at.begin(), at.end(), value);
  const auto knot = static_cast<std::size_t>(next - at.begin()) - 1;
  return {knot, (value - at[knot]) / (at[knot + 1] - at[knot])};
}

template <typename Values>
double valueAt(const Values& values, KnotPlace place) {
  const double below = values[place.knot];
  return place.share > 0.0 ? below + place.share * (values[place.knot + 1] - below) : below;
}

// Straight between six values of the fact, constant below and above them. A fact of fewer values
// repeats the last.
template <typename Facts>
struct Curve {
  static constexpr std::size_t kKnots = 6;
  double Facts::*fact;
  std::array<double, kKnots> at;  // rising
  std::array<double, kKnots> logOdds;

  double operator()(const Facts& facts) const {
    return valueAt(logOdds, placeAmong(at, facts.*fact));
  }
};

template <typename Facts, std::size_t N>
double logOdds(double prior, const std::array<Curve<Facts>, N>& curves, const Facts& facts) {
  double sum = prior;
  for (const Curve<Facts>& curve : curves) sum += curve(facts);
  return sum;
}

}  // namespace kelpie::vision
