// SPDX-License-Identifier: Apache-2.0
// Least squares that some wrong sightings do not bend: Levenberg and Marquardt on residuals under
// Cauchy's loss, with a prior for each unknown. Standard deviations count residuals of one group as
// sharing their errors, however many they are ("sandwich" covariance). Finds the minimum next to
// its start, which may not be the lowest.
#pragma once

#include <functional>
#include <vector>

namespace kelpie::calibrate {

using Numbers = std::vector<double>;

struct FitUnknown {
  double start = 0.0;
  double step = 1e-3;    // for the derivative
  double prior = 0.0;    // most likely value of those not yet measured
  double priorSd = 0.0;  // 0: nothing is known
  bool fixed = false;    // stays at its start
};

struct FitProblem {
  std::vector<FitUnknown> unknowns;
  // Residuals in units of their standard deviations, always as many as `groups`.
  std::function<void(const Numbers& unknowns, Numbers& residuals)> residuals;
  std::vector<int> groups;  // of each residual, counted from 0
  double cauchy = 2.0;      // a residual as large has half its weight
};

struct Fit {
  Numbers value;
  Numbers sd;         // 0 of what is fixed
  Numbers residuals;  // at `value`
  double cost = 0.0;  // half the sum of losses, prior included
  bool converged = false;
};

Fit robustFit(const FitProblem& problem);

}  // namespace kelpie::calibrate
