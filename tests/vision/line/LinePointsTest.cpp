// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/vision/Painting.h"
#include "vision/Refusal.h"
#include "vision/Vision.h"
#include "vision/line/LinePoints.h"

namespace kelpie::vision {
namespace {

std::size_t count(const Percepts& percepts, LinePointKind kind) {
  std::size_t n = 0;
  for (const LinePoint& point : percepts.linePoints) n += point.kind == kind ? 1 : 0;
  return n;
}

Painting lineAt(double distance) {
  Painting p;
  p.lineAt = distance;
  p.noise = 3.0;
  return p;
}

TEST(LinePoints, LieOnThePaintedLine) {
  for (const double d : {40.0, 70.0, 110.0}) {
    const Seen seen = look(lineAt(d), cameraAt(16, 0, -15));
    EXPECT_GE(count(seen.percepts, LinePointKind::line), 19U) << d;
    for (const LinePoint& point : seen.percepts.linePoints) {
      if (point.kind != LinePointKind::line) continue;
      EXPECT_NEAR(point.position.y, d, 0.04 * d);
    }
  }
}

TEST(LinePoints, NoneAreSeenOnPlainCarpet) {
  Painting p;
  p.noise = 3.0;
  EXPECT_EQ(count(look(p, cameraAt(16, 0, -15)).percepts, LinePointKind::line), 0U);
}

TEST(LinePoints, WhiteWallBeyondTheCarpetGivesNone) {
  Painting p;
  p.carpetEnd = 100;
  p.walls.push_back({{-300, 100}, {300, 100}, 0, 20, kWhitePaint});
  EXPECT_EQ(count(look(p, cameraAt(16, 0, -10)).percepts, LinePointKind::line), 0U);
}

TEST(LinePoints, WhiteBetweenCarpetAndFloorGivesNone) {
  Painting p = lineAt(70);
  p.carpetEnd = 71.25;
  EXPECT_EQ(count(look(p, cameraAt(16, 0, -10)).percepts, LinePointKind::line), 0U);
}

TEST(LinePoints, WhiteFootUnderABlackBodyGivesNone) {
  Painting p;
  p.walls.push_back({{-15, 60}, {15, 60}, 0, 3, kWhitePaint});
  p.walls.push_back({{-15, 60}, {15, 60}, 3, 9, {20, 126, 128}});
  EXPECT_EQ(count(look(p, cameraAt(16, 0, -15)).percepts, LinePointKind::line), 0U);
}

TEST(LinePoints, NoneAreTakenWhileTheHeadTurnsFast) {
  const auto input = std::make_unique<FrameInput>();
  const auto state = stateForPaintings();
  const CameraPose camera = cameraAt(16, 0, -15);
  paint(lineAt(60), camera, input->image);
  BodyState body = bodyOf(camera);
  body.headSpeed = 0.089;  // 5.1 deg per frame
  EXPECT_FALSE(step({*input, body}, {}, *state).linePoints.empty());
  body.headSpeed = 0.092;  // 5.3 deg per frame
  EXPECT_TRUE(step({*input, body}, {}, *state).linePoints.empty());
}

TEST(LinePoints, WeightIsOneNearAndFallsToNothing) {
  const LinePointParams params;
  EXPECT_EQ(pointWeight(LinePointKind::line, 30, params), 1.0);
  EXPECT_EQ(pointWeight(LinePointKind::line, 70, params), 1.0);
  EXPECT_NEAR(pointWeight(LinePointKind::line, 210, params), 0.5, 1e-9);
  EXPECT_EQ(pointWeight(LinePointKind::line, 350, params), 0.0);
  EXPECT_EQ(pointWeight(LinePointKind::line, 500, params), 0.0);
}

// 45 degree white border, its foot 60 cm ahead, in steps of 2 mm.
Painting borderAhead() {
  Painting p;
  for (int i = 0; i < 50; ++i)
    p.walls.push_back(
        {{-300, 60.0 + 0.2 * i}, {300, 60.0 + 0.2 * i}, 0.2 * i, 0.2 * i + 0.25, kWhitePaint});
  return p;
}

TEST(LinePoints, NearLineIsKeptHoweverWideInPixels) {
  Painting p;
  p.lineAt = 20.0;  // 12 cm before the camera: 21 px
  const Percepts seen = look(p, cameraAt(16, 0, -50)).percepts;
  EXPECT_GE(count(seen, LinePointKind::line), 19U);
}

TEST(LinePoints, FootOfABorderIsSeenOnlyOnAFieldThatHasOne) {
  VisionParams params;
  EXPECT_EQ(
      count(look(borderAhead(), cameraAt(16, 0, -15), params).percepts, LinePointKind::border), 0U);
  params.field = *body::fieldDescription("2004");
  const Percepts seen = look(borderAhead(), cameraAt(16, 0, -15), params).percepts;
  EXPECT_GE(count(seen, LinePointKind::border), 19U);
  for (const LinePoint& point : seen.linePoints) {
    if (point.kind != LinePointKind::border) continue;
    EXPECT_NEAR(point.position.y, 60.0, 1.5);
  }
}

TEST(LinePoints, WhiteTooWideForALineAndTooNarrowForABorderGivesNone) {
  VisionParams params;
  params.field = *body::fieldDescription("2004");
  Painting p;
  for (int i = 0; i < 8; ++i)  // flat, 8 cm deep
    p.walls.push_back({{-300, 60.0 + i}, {300, 60.0 + i}, 0.0, 0.3, kWhitePaint});
  const Percepts seen = look(p, cameraAt(16, 0, -15), params).percepts;
  EXPECT_EQ(count(seen, LinePointKind::line) + count(seen, LinePointKind::border), 0U);
  EXPECT_GT(seen.counts.refused[static_cast<std::size_t>(Refusal::lineAmbiguous)], 10);
}

TEST(LinePoints, FewerThanFourOfAKindAreDropped) {
  Painting p = lineAt(60);
  const CameraPose camera = cameraAt(16, 0, -15);
  VisionParams params;
  const auto all = static_cast<double>(count(look(p, camera).percepts, LinePointKind::line));
  params.line.minOfKind = all;
  EXPECT_EQ(count(look(p, camera, params).percepts, LinePointKind::line), all);
  params.line.minOfKind = all + 1.0;
  const Percepts none = look(p, camera, params).percepts;
  EXPECT_EQ(count(none, LinePointKind::line), 0U);
  EXPECT_GT(count(none, LinePointKind::field), 4U);  // another kind is left alone
}

TEST(LinePoints, PointsWithoutWeightAreDropped) {
  VisionParams params;
  params.line.noWeight = 80;
  const Percepts seen = look(lineAt(100), cameraAt(16, 0, -15), params).percepts;
  EXPECT_EQ(count(seen, LinePointKind::line), 0U);
  for (const LinePoint& point : seen.linePoints) EXPECT_LE(point.position.norm(), 80.0);
}

TEST(LinePoints, FieldPointsWeighTheSameUpToTheEnd) {
  EXPECT_EQ(pointWeight(LinePointKind::field, 349, {}), 1.0);
  EXPECT_EQ(pointWeight(LinePointKind::field, 351, {}), 0.0);
}

// Largest over smallest gap between neighbours on the ground, along the middle column.
double unevenness(double min, double max) {
  VisionParams params;
  params.line.minFieldInterval = min;
  params.line.maxFieldInterval = max;
  const Percepts seen = look(Painting{}, cameraAt(18, 0, -15), params).percepts;
  double low = 1e9;
  double high = 0.0;
  const LinePoint* before = nullptr;
  for (const LinePoint& p : seen.linePoints) {
    if (std::fabs(p.pixel.x - 104.5) > 0.1) continue;
    if (before != nullptr) {
      low = std::min(low, distance(p.position, before->position));
      high = std::max(high, distance(p.position, before->position));
    }
    before = &p;
  }
  return high / low;
}

TEST(LinePoints, ShrinkingIntervalSpreadsFieldPointsEvenly) {
  EXPECT_LT(unevenness(2, 60), 3.0);
  EXPECT_GT(unevenness(12, 12), 10.0);  // a constant interval
}

}  // namespace
}  // namespace kelpie::vision
