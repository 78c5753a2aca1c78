// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "vision/ball/ConeFit.h"

namespace kelpie::vision {
namespace {

// Outline of a sphere of radius 4.2 at a place in the camera frame, projected by hand.
EdgePoints outline(double x, double y, double z, int count, double share = 1.0) {
  const double d = std::sqrt(x * x + y * y + z * z);
  const double sine = 4.2 / d;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double a[3] = {x / d, y / d, z / d};
  const double n = std::hypot(a[0], a[2]);
  const double u[3] = {a[2] / n, 0.0, -a[0] / n};
  const double v[3] = {a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2],
                       a[0] * u[1] - a[1] * u[0]};
  EdgePoints points;
  for (int i = 0; i < count; ++i) {
    const double t = 6.283185307 * share * i / count;
    double r[3];
    for (int k = 0; k < 3; ++k) {
      r[k] = cosine * a[k] + sine * (std::cos(t) * u[k] + std::sin(t) * v[k]);
    }
    points.push_back({104.0 + 192.0 * r[0] / r[2], 80.0 + 192.0 * r[1] / r[2]});
  }
  return points;
}

TEST(ConeFit, RangeIsExactInTheMiddleAndInTheCorner) {
  for (const double range : {12.0, 30.0, 100.0, 350.0}) {
    for (const double off : {0.0, 0.5}) {
      const double x = off * range, y = 0.4 * off * range;
      const Cone cone = fitCone(outline(x, y, range, 12), Lens{});
      ASSERT_TRUE(cone.valid);
      const double expected = std::sqrt(x * x + y * y + range * range);
      EXPECT_NEAR(4.2 / cone.sinHalf, expected, 1e-4 * expected);
      EXPECT_NEAR(cone.axis.x, x / expected, 1e-6);
    }
  }
}

TEST(ConeFit, OneThirdOfTheOutlineIsEnough) {
  const Cone cone = fitCone(outline(10, 5, 60, 12, 0.34), Lens{});
  ASSERT_TRUE(cone.valid);
  EXPECT_NEAR(4.2 / cone.sinHalf, std::sqrt(3725.0), 0.01);
}

TEST(ConeFit, PointsOffTheOutlineAreDropped) {
  EdgePoints points = outline(0, 0, 50, 14);
  for (const std::size_t i : {3U, 8U}) {
    points[i] = {104.0 + 0.6 * (points[i].x - 104.0), 80.0 + 0.6 * (points[i].y - 80.0)};
  }
  const Cone cone = fitCone(points, Lens{});
  ASSERT_TRUE(cone.valid);
  EXPECT_EQ(cone.kept, 12U);
  EXPECT_NEAR(4.2 / cone.sinHalf, 50.0, 0.05);
}

TEST(ConeFit, NothingComesOfPointsOnALineOrOfTooFew) {
  EdgePoints points;
  EXPECT_FALSE(fitCone(points, Lens{}).valid);
  for (int i = 0; i < 10; ++i) points.push_back({20.0 + 10.0 * i, 60.0});
  EXPECT_FALSE(fitCone(points, Lens{}).valid);
}

}  // namespace
}  // namespace kelpie::vision
