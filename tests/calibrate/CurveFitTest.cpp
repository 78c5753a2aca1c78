// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/Random.h"
#include "tools/calibrate/distance/CurveFit.h"

namespace kelpie::calibrate {
namespace {

// The odds that an example is positive: a valley over the first fact, a step of the second, nothing
// of the third, which never changes.
double trueOdds(const std::vector<double>& facts) {
  return 2.0 * std::fabs(facts[0] - 5.0) - 4.0 + (facts[1] > 0.5 ? 1.5 : -1.5);
}

std::vector<CurveExample> drawn(int count) {
  Random random(77);
  std::vector<CurveExample> examples;
  for (int i = 0; i < count; ++i) {
    CurveExample e;
    e.facts = {random.uniform(0.0, 10.0), random.chance(0.5) ? 1.0 : 0.0, 3.0};
    e.positive = random.uniform() < 1.0 / (1.0 + std::exp(-trueOdds(e.facts)));
    e.fold = i % 4;
    examples.push_back(e);
  }
  return examples;
}

TEST(CurveFit, FindsTheOddsThatMadeTheExamples) {
  CurveFitParams params;
  params.ridge = 0.1;
  const CurveFit fit = fitCurves(drawn(20000), params);
  for (const double x : {1.0, 3.0, 7.0, 9.0})
    for (const double step : {0.0, 1.0})
      EXPECT_NEAR(fit({x, step, 3.0}), trueOdds({x, step, 3.0}), 0.8) << x << " " << step;
  EXPECT_NEAR(fit({1.0, 1.0, 3.0}) - fit({1.0, 0.0, 3.0}), 3.0, 0.3);
}

TEST(CurveFit, IsConstantOutsideItsKnotsAndFlatForAFactThatTellsNothing) {
  const CurveFit fit = fitCurves(drawn(2000), {});
  EXPECT_EQ(fit.curves[0](-1e9), fit.curves[0].logOdds.front());
  EXPECT_EQ(fit.curves[0](1e9), fit.curves[0].logOdds.back());
  EXPECT_EQ(fit.curves[2](0.0), fit.curves[2](99.0));
}

TEST(CurveFit, CurvesAreNothingInTheMeanOfTheNegatives) {
  const auto examples = drawn(3000);
  const CurveFit fit = fitCurves(examples, {});
  double sum = 0.0;
  for (const auto& e : examples) sum += e.positive ? 0.0 : fit.curves[0](e.facts[0]);
  EXPECT_NEAR(sum, 0.0, 1e-6);
}

TEST(CurveFit, WeightMovesTheOdds) {
  auto examples = drawn(4000);
  const double before = fitCurves(examples, {})({5.0, 0.0, 3.0});
  for (auto& e : examples) e.weight = e.positive ? 10.0 : 1.0;
  EXPECT_GT(fitCurves(examples, {})({5.0, 0.0, 3.0}), before + 1.5);
}

// A fact that is each example's own number tells nothing about the others.
TEST(CurveFit, HeldOutOddsDoNotKnowTheirExamples) {
  auto examples = drawn(400);
  for (std::size_t i = 0; i < examples.size(); ++i) examples[i].facts[2] = static_cast<double>(i);
  const auto odds = heldOut(examples, 4, {});
  auto turned = examples;
  for (auto& e : turned)
    if (e.fold == 1) e.positive = !e.positive;
  const auto after = heldOut(turned, 4, {});
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (examples[i].fold != 1) continue;
    EXPECT_EQ(odds[i], after[i]);
  }
}

}  // namespace
}  // namespace kelpie::calibrate
