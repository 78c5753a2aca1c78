// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/walk/Locus.h"

namespace kelpie::actuator {
namespace {

const std::array<LocusShape, 3> kShapes{LocusShape::rectangular, LocusShape::elliptical,
                                        LocusShape::halfEllipse};

TEST(Locus, EveryShapeGoesFromAheadToBehindAndBackThroughTheAir) {
  for (const LocusShape shape : kShapes)
    for (const double duty : {0.4, 0.5, 0.65}) {
      EXPECT_NEAR(locusPoint(shape, 0.0, duty, 0.5).along, 1.0, 1e-9);
      EXPECT_NEAR(locusPoint(shape, duty, duty, 0.5).along, -1.0, 1e-9);
      EXPECT_NEAR(locusPoint(shape, 1.0 - 1e-12, duty, 0.5).along, 1.0, 1e-6);
      EXPECT_NEAR(locusPoint(shape, 0.5 + 0.5 * duty, duty, 0.5).height, 1.0, 1e-9);
    }
}

TEST(Locus, IsContinuous) {
  for (const LocusShape shape : kShapes)
    for (int i = 0; i < 1000; ++i) {
      const LocusPoint a = locusPoint(shape, i / 1000.0, 0.5, 1.0);
      const LocusPoint b = locusPoint(shape, (i + 1) % 1000 / 1000.0, 0.5, 1.0);
      ASSERT_LT(std::fabs(a.along - b.along), 0.012);
      ASSERT_LT(std::fabs(a.height - b.height), 0.012);
    }
}

TEST(Locus, OnlyTheEllipsePressesIntoTheGround) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(locusPoint(LocusShape::rectangular, i / 100.0, 0.5, 0).height, 0.0);
    EXPECT_EQ(locusPoint(LocusShape::halfEllipse, i / 100.0, 0.5, 0).height, 0.0);
    EXPECT_LE(locusPoint(LocusShape::elliptical, i / 100.0, 0.5, 0).height, 0.0);
  }
}

TEST(Locus, FullLeadLeavesAndMeetsTheGroundAtTheSpeedOfTheStroke) {
  const double stroke = -2.0 / 0.6;  // half strokes a step
  for (const double at : {0.6, 1.0 - 1e-4}) {
    const double speed = (locusPoint(LocusShape::halfEllipse, at + 1e-4, 0.6, 1).along -
                          locusPoint(LocusShape::halfEllipse, at, 0.6, 1).along) /
                         1e-4;
    EXPECT_NEAR(speed, stroke, 0.02);
  }
}

// A third of the time goes up and a third down, so that nothing is caught.
TEST(Locus, TheRectangleIsHighWhileItGoesAcross) {
  for (int i = 70; i <= 80; ++i)
    EXPECT_NEAR(locusPoint(LocusShape::rectangular, i / 100.0, 0.5, 0).height, 1.0, 1e-9);
}

}  // namespace
}  // namespace kelpie::actuator
