// SPDX-License-Identifier: Apache-2.0
// How much noise a robot has, by how large its innovations are.
#include <gtest/gtest.h>

#include <limits>

#include "gps/pose/NoiseScale.h"
#include "robot/core/Random.h"

namespace kelpie::gps {
namespace {

PoseMode narrow() {
  PoseMode mode;
  mode.covariance = {4, 0, 0, 0, 4, 0, 0, 0, 1e-4};
  return mode;
}

// After so many innovations of a filter whose variances, times the scale, are `claimed` times those
// of its errors.
double scaleAfter(int count, double claimed) {
  const NoiseScaleParams params;
  Random random(3);
  double scale = 1.0;
  for (int i = 0; i < count; ++i) {
    const double error = random.gaussian(0.0, 1.0);
    noteInnovation(narrow(), error * error / (claimed * scale), params, scale);
  }
  return scale;
}

TEST(NoiseScale, ASoundRobotHasLess) { EXPECT_LT(scaleAfter(4000, 16.0), 0.5); }

TEST(NoiseScale, AWornOneHasMore) { EXPECT_GT(scaleAfter(3000, 1.0), 2.0); }

TEST(NoiseScale, StaysWithinItsBounds) {
  EXPECT_EQ(scaleAfter(100000, 1e6), NoiseScaleParams{}.min);
  EXPECT_EQ(scaleAfter(100000, 1e-3), NoiseScaleParams{}.max);
}

TEST(NoiseScale, AFalseSightingCountsNoMoreThanALargeOne) {
  const NoiseScaleParams params;
  double large = 1.0;
  double absurd = 1.0;
  noteInnovation(narrow(), 9.0, params, large);
  noteInnovation(narrow(), 1e12, params, absurd);
  EXPECT_EQ(large, absurd);
}

TEST(NoiseScale, AWideModeSaysNothingOfIt) {
  PoseMode wide;
  wide.covariance = {2500, 0, 0, 0, 2500, 0, 0, 0, 0.1};
  double scale = 1.0;
  noteInnovation(wide, 0.0, {}, scale);
  EXPECT_EQ(scale, 1.0);
}

TEST(NoiseScale, IsNotMovedByNaN) {
  double scale = 1.0;
  noteInnovation(narrow(), std::numeric_limits<double>::quiet_NaN(), {}, scale);
  EXPECT_EQ(scale, 1.0);
}

}  // namespace
}  // namespace kelpie::gps
