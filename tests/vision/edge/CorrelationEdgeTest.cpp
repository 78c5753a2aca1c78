// SPDX-License-Identifier: Apache-2.0
// The fit of thesis 2006, kept for comparison.
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "tools/experiments/baselines/CorrelationEdge.h"

namespace kelpie::baselines {
namespace {

vision::EdgeFeatures points(double slope, double noise, int count = 24) {
  Random random(2);
  vision::EdgeFeatures features;
  for (int i = 0; i < count; ++i) {
    const double x = 208.0 * (i + 0.5) / count;
    features.push_back({{x, 60 + slope * x + noise * random.gaussian()}, false, 1.0});
  }
  return features;
}

TEST(CorrelationEdge, RegressionIsExactOnALineAndItsCorrelationIsOne) {
  const SlopeLine line = regression(points(-0.25, 0.0));
  EXPECT_NEAR(line.slope, -0.25, 1e-12);
  EXPECT_NEAR(line.offset, 60.0, 1e-9);
  EXPECT_NEAR(line.r, -1.0, 1e-12);
}

TEST(CorrelationEdge, CorrelationOfAHandCase) {
  vision::EdgeFeatures three;
  three.push_back({{1, 1}, false, 1.0});
  three.push_back({{2, 3}, false, 1.0});
  three.push_back({{3, 2}, false, 1.0});
  EXPECT_NEAR(regression(three).r, 0.5, 1e-12);
}

TEST(CorrelationEdge, ALevelEdgeIsRejectedHoweverGood) {
  EXPECT_FALSE(correlationEdge(points(0.0, 0.5), {}).has_value());
  CorrelationParams byCount;
  byCount.fitness = EdgeFitness::count;
  EXPECT_TRUE(correlationEdge(points(0.0, 0.5), byCount).has_value());
}

TEST(CorrelationEdge, ASlopingEdgeIsFound) {
  const auto line = correlationEdge(points(0.1, 1.0), {});
  ASSERT_TRUE(line.has_value());
  EXPECT_NEAR(line->slope, 0.1, 0.02);
  EXPECT_GT(line->r, 0.85);
}

TEST(CorrelationEdge, BetweenTheThresholdsTheBestOfAllRoundsIsTaken) {
  // Noise of 1 px on a slope of 0.02: |r| about 0.77.
  CorrelationParams params;
  const auto line = correlationEdge(points(0.02, 1.0), params);
  ASSERT_TRUE(line.has_value());
  EXPECT_GT(line->r, 0.55);
  params.minCorrelation = 0.999;
  params.stopAboveCorrelation = 0.9999;
  EXPECT_FALSE(correlationEdge(points(0.02, 1.0), params).has_value());
}

TEST(CorrelationEdge, TooFewPointsGiveNone) {
  EXPECT_FALSE(correlationEdge(points(0.1, 0.0, 7), {}).has_value());
}

}  // namespace
}  // namespace kelpie::baselines
