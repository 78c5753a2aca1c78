// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/Random.h"
#include "tools/calibrate/RobustFit.h"

namespace kelpie::calibrate {
namespace {

// y = a + b x with noise of one, measured at x = 0..n-1.
struct Line {
  std::vector<double> y;
  explicit Line(int n, double noise = 1.0) {
    Random random(5);
    for (int x = 0; x < n; ++x) y.push_back(3.0 + 0.5 * x + random.gaussian(0.0, noise));
  }
  FitProblem problem() const {
    FitProblem p;
    p.unknowns = {{}, {}};
    for (std::size_t i = 0; i < y.size(); ++i) p.groups.push_back(static_cast<int>(i));
    p.residuals = [this](const Numbers& v, Numbers& r) {
      r.clear();
      for (std::size_t i = 0; i < y.size(); ++i)
        r.push_back(y[i] - v[0] - v[1] * static_cast<double>(i));
    };
    return p;
  }
};

TEST(RobustFit, ALineIsFoundWithinItsDeviations) {
  const Line line(200);
  const Fit fit = robustFit(line.problem());
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.value[0], 3.0, 3.0 * fit.sd[0]);
  EXPECT_NEAR(fit.value[1], 0.5, 3.0 * fit.sd[1]);
  EXPECT_NEAR(fit.sd[0], 2.0 / std::sqrt(200.0), 0.06);  // least squares' own
}

TEST(RobustFit, AFifthOfWrongMeasurementsHardlyMovesIt) {
  Line line(200);
  for (std::size_t i = 0; i < line.y.size(); i += 5) line.y[i] += 60.0;
  const Fit fit = robustFit(line.problem());
  EXPECT_NEAR(fit.value[0], 3.0, 0.5);
  EXPECT_NEAR(fit.value[1], 0.5, 0.01);
}

TEST(RobustFit, TheSameMeasurementTenTimesOverIsNoSurerInOneGroup) {
  Line once(40);
  Line often(0);
  for (const double y : once.y)
    for (int i = 0; i < 10; ++i) often.y.push_back(y);
  FitProblem p = often.problem();
  p.residuals = [&often](const Numbers& v, Numbers& r) {
    r.clear();
    for (std::size_t i = 0; i < often.y.size(); ++i)
      r.push_back(often.y[i] - v[0] - v[1] * static_cast<double>(i / 10));
  };
  for (std::size_t i = 0; i < p.groups.size(); ++i) p.groups[i] = static_cast<int>(i / 10);
  EXPECT_NEAR(robustFit(p).sd[0], robustFit(once.problem()).sd[0], 0.01);
  for (std::size_t i = 0; i < p.groups.size(); ++i) p.groups[i] = static_cast<int>(i);
  EXPECT_LT(robustFit(p).sd[0], 0.5 * robustFit(once.problem()).sd[0]);
}

TEST(RobustFit, WhatIsNotMeasuredKeepsItsPrior) {
  Line line(50);
  FitProblem p = line.problem();
  p.unknowns.push_back({9.0, 1e-3, 7.0, 2.0});
  const Fit fit = robustFit(p);
  EXPECT_NEAR(fit.value[2], 7.0, 1e-3);
  EXPECT_NEAR(fit.sd[2], 2.0, 0.01);
}

TEST(RobustFit, WhatIsFixedStaysAndHasNoDeviation) {
  Line line(50);
  FitProblem p = line.problem();
  p.unknowns[1].fixed = true;
  p.unknowns[1].start = 0.25;
  const Fit fit = robustFit(p);
  EXPECT_EQ(fit.value[1], 0.25);
  EXPECT_EQ(fit.sd[1], 0.0);
  EXPECT_GT(fit.value[0], 5.0);
}

}  // namespace
}  // namespace kelpie::calibrate
