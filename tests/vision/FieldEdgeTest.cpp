// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/Random.h"
#include "tests/vision/Painting.h"
#include "vision/FieldEdge.h"

namespace kelpie::vision {
namespace {

TEST(FieldEdge, IsWhereTheCarpetEnds) {
  Painting p;
  p.carpetEnd = 200;
  p.noise = 3.0;
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_TRUE(seen.percepts.fieldEdge.present);
  // 16 cm down and 192 cm ahead of the camera, which looks 5 deg down.
  const double row = 80 + 192 * std::tan(std::atan2(16.0, 192.0) - 5 * 3.14159265 / 180);
  EXPECT_NEAR(seen.percepts.fieldEdge.atLeft, row, 2.0);
  EXPECT_NEAR(seen.percepts.fieldEdge.atRight, row, 2.0);
}

TEST(FieldEdge, NoneIsClaimedWhenAllIsGreenOrNothingIs) {
  EXPECT_FALSE(look({}, cameraAt(16, 0, -45)).percepts.fieldEdge.present);
  Painting bare;
  bare.carpet = kFloorPaint;
  EXPECT_FALSE(look(bare, cameraAt(16, 0, -5)).percepts.fieldEdge.present);
}

TEST(FieldEdge, WhiteLineOnTheFieldIsNotTheEdge) {
  Painting p;
  p.carpetEnd = 200;
  p.lineAt = 90;
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_TRUE(seen.percepts.fieldEdge.present);
  EXPECT_LT(seen.percepts.fieldEdge.atLeft, 84.0);
}

TEST(FieldEdge, OrangeThatFillsTheUpperImageIsNotTheEdge) {
  Painting p;
  p.walls.push_back({{-60, 35}, {60, 35}, 0, 60, kOrangePaint});
  EXPECT_FALSE(look(p, cameraAt(16, 0, -45)).percepts.fieldEdge.present);
}

TEST(FieldEdge, GoalAndBallBeforeItDoNotBendIt) {
  Painting p;
  p.carpetEnd = 230;
  addGoal(p, 0, 200, kBluePaint);
  p.balls.push_back({40, 120});
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_TRUE(seen.percepts.fieldEdge.present);
  const double row = 80 + 192 * std::tan(std::atan2(16.0, 222.0) - 5 * 3.14159265 / 180);
  EXPECT_NEAR(seen.percepts.fieldEdge.atLeft, row, 3.0);
  EXPECT_NEAR(seen.percepts.fieldEdge.atRight, row, 3.0);
}

// Share of trials within 6 px at both ends: the measure of checklist E4, 30 % outliers.
TEST(FieldEdge, SurvivesAThirdOfOutliersOnALevelLine) {
  Random random(5);
  int good = 0;
  for (int trial = 0; trial < 300; ++trial) {
    EdgeFeatures features;
    for (int i = 0; i < 48; ++i) {
      const double x = 4.5 + 4 * i;
      const bool wrong = random.chance(0.3);
      features.push_back({x, wrong ? random.uniform(10, 150) : 60 + random.gaussian()});
    }
    FieldEdgeParams params;
    params.seed = static_cast<std::uint32_t>(trial);
    const FieldEdgePercept edge = fitFieldEdge(features, params);
    const double worst = std::max(std::fabs(edge.atLeft - 60), std::fabs(edge.atRight - 60));
    good += edge.present && worst < 6 ? 1 : 0;
  }
  EXPECT_GT(good, 290);
}

TEST(FieldEdge, ScatteredFeaturesSupportNone) {
  Random random(6);
  EdgeFeatures features;
  for (int i = 0; i < 48; ++i) features.push_back({4.5 + 4 * i, random.uniform(5, 155)});
  EXPECT_FALSE(fitFieldEdge(features, {}).present);
}

}  // namespace
}  // namespace kelpie::vision
