// SPDX-License-Identifier: Apache-2.0
// Learns log odds as a sum of curves over plain facts from examples: logistic regression on the
// facts' hat functions, by Newton steps, with a ridge. Curves that no example tells apart stay
// flat.
#pragma once

#include <vector>

namespace kelpie::calibrate {

struct CurveExample {
  std::vector<double> facts;
  bool positive = false;
  double weight = 1.0;
  int fold = 0;
};

// Straight between its knots, constant outside. A fact of one value only has a curve of one knot.
struct FittedCurve {
  std::vector<double> at;  // rising
  std::vector<double> logOdds;

  double operator()(double value) const;
};

// Each curve averages 0 over the negative examples.
struct CurveFit {
  double prior = 0.0;
  std::vector<FittedCurve> curves;  // one for each fact

  double operator()(const std::vector<double>& facts) const;
};

struct CurveFitParams {
  std::size_t knots = 6;
  double ridge = 10.0;  // 1 / variance of a coefficient
  int steps = 25;
};

// All examples have the same number of facts; there is at least one.
CurveFit fitCurves(const std::vector<CurveExample>& examples, const CurveFitParams& params);

// For each example the log odds from a fit on the examples of the other folds.
std::vector<double> heldOut(const std::vector<CurveExample>& examples, int folds,
                            const CurveFitParams& params);

}  // namespace kelpie::calibrate
