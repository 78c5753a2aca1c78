// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/Angle.h"
#include "robot/core/Maths.h"
#include "robot/core/Random.h"

namespace kelpie {
namespace {

TEST(Maths, AgreesWithTheCLibraryToAFewUnitsInTheLastPlace) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-30.0, 30.0);
    const double y = random.uniform(-30.0, 30.0);
    EXPECT_NEAR(maths::sin(x), std::sin(x), 4e-16);
    EXPECT_NEAR(maths::cos(x), std::cos(x), 4e-16);
    EXPECT_NEAR(maths::atan2(y, x), std::atan2(y, x), 9e-16);
    EXPECT_NEAR(maths::exp(x) / std::exp(x), 1.0, 1e-15);
    EXPECT_NEAR(maths::log(std::fabs(x)), std::log(std::fabs(x)), 2e-15);
    EXPECT_NEAR(maths::asin(x / 30.0), std::asin(x / 30.0), 9e-16);
  }
}

TEST(Maths, SineAndCosineAloneHaveTheBitsOfThePair) {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-30.0, 30.0);
    const maths::SinCos both = maths::sinCos(x);
    EXPECT_EQ(maths::sin(x), both.sin);
    EXPECT_EQ(maths::cos(x), both.cos);
  }
}

TEST(Maths, ExtremesStayFinite) {
  EXPECT_EQ(maths::exp(-1e9), 0.0);
  EXPECT_TRUE(std::isfinite(maths::exp(1e9)));
  EXPECT_TRUE(std::isfinite(maths::log(0.0)));
  EXPECT_EQ(maths::atan2(0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(maths::asin(1.5), maths::kPi / 2);
}

TEST(Angle, IsAlwaysAboveMinusPiAndAtMostPi) {
  Random random(8);
  for (int i = 0; i < 10000; ++i) {
    const double r = Angle::rad(random.uniform(-1000.0, 1000.0)).rad();
    EXPECT_GT(r, -maths::kPi);
    EXPECT_LE(r, maths::kPi);
  }
  EXPECT_DOUBLE_EQ(Angle::rad(-maths::kPi).rad(), maths::kPi);
}

TEST(Angle, DifferencesWrap) {
  EXPECT_NEAR((Angle::deg(-170) - Angle::deg(170)).deg(), 20.0, 1e-12);
}

}  // namespace
}  // namespace kelpie
