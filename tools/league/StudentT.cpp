// SPDX-License-Identifier: Apache-2.0
#include "tools/league/StudentT.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::league {
namespace {

// 1 + 1/2 c2 + (1 3)/(2 4) c2^2 + ... for an even number of degrees of freedom,
// 1 + 2/3 c2 + (2 4)/(3 5) c2^2 + ... for an odd one, `terms` of them.
double series(double c2, int terms, bool odd) {
  double sum = 0.0;
  double term = 1.0;
  for (int k = 1; k <= terms; ++k) {
    sum += term;
    const double whole = 2.0 * k;
    term *= c2 * (odd ? whole / (whole + 1.0) : (whole - 1.0) / whole);
  }
  return sum;
}

// P(|T| < t) for t >= 0.
double shareWithin(double t, int freedom) {
  const double n = freedom;
  const double c2 = n / (n + t * t);  // cos^2 of theta = atan(t / sqrt(n))
  const double sine = t / std::sqrt(n + t * t);
  if (freedom % 2 == 0) return sine * series(c2, freedom / 2, false);
  const double inner = sine * std::sqrt(c2) * series(c2, (freedom - 1) / 2, true);
  return 2.0 / maths::kPi * (std::atan(t / std::sqrt(n)) + inner);
}

}  // namespace

double studentTail(double t, int freedom) {
  if (std::isinf(t)) return t > 0.0 ? 0.0 : 1.0;
  const double within = maths::clamp(shareWithin(std::fabs(t), freedom), 0.0, 1.0);
  return t >= 0.0 ? 0.5 * (1.0 - within) : 0.5 * (1.0 + within);
}

double studentQuantile(double tail, int freedom) {
  double low = 0.0;
  double high = 1.0;
  while (studentTail(high, freedom) > tail) high *= 2.0;
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (studentTail(middle, freedom) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace kelpie::league
