// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/vision/Painting.h"
#include "vision/LinePoints.h"
#include "vision/Vision.h"

namespace kelpie::vision {
namespace {

Painting lineAt(double distance) {
  Painting p;
  p.lineAt = distance;
  p.noise = 3.0;
  return p;
}

TEST(LinePoints, LieOnThePaintedLine) {
  for (const double d : {40.0, 70.0, 110.0}) {
    const Seen seen = look(lineAt(d), cameraAt(16, 0, -15));
    EXPECT_GE(seen.percepts.linePoints.size(), 19U) << d;
    for (const LinePoint& point : seen.percepts.linePoints) {
      EXPECT_NEAR(point.position.y, d, 0.04 * d);
    }
  }
}

TEST(LinePoints, NoneAreSeenOnPlainCarpet) {
  Painting p;
  p.noise = 3.0;
  EXPECT_TRUE(look(p, cameraAt(16, 0, -15)).percepts.linePoints.empty());
}

TEST(LinePoints, WhiteWallBeyondTheCarpetGivesNone) {
  Painting p;
  p.carpetEnd = 100;
  p.walls.push_back({{-300, 100}, {300, 100}, 0, 20, kWhitePaint});
  EXPECT_TRUE(look(p, cameraAt(16, 0, -10)).percepts.linePoints.empty());
}

TEST(LinePoints, WhiteBetweenCarpetAndFloorGivesNone) {
  Painting p = lineAt(70);
  p.carpetEnd = 71.25;
  EXPECT_TRUE(look(p, cameraAt(16, 0, -10)).percepts.linePoints.empty());
}

TEST(LinePoints, WhiteFootUnderABlackBodyGivesNone) {
  Painting p;
  p.walls.push_back({{-15, 60}, {15, 60}, 0, 3, kWhitePaint});
  p.walls.push_back({{-15, 60}, {15, 60}, 3, 9, {20, 126, 128}});
  EXPECT_TRUE(look(p, cameraAt(16, 0, -15)).percepts.linePoints.empty());
}

TEST(LinePoints, NoneAreTakenWhileTheHeadTurnsFast) {
  const auto input = std::make_unique<FrameInput>();
  const auto state = std::make_unique<VisionState>();
  const CameraPose camera = cameraAt(16, 0, -15);
  paint(lineAt(60), camera, input->image);
  BodyState body = bodyOf(camera);
  body.headSpeed = 0.051;  // 2.9 deg per frame
  EXPECT_FALSE(step({*input, body}, {}, *state).linePoints.empty());
  body.headSpeed = 0.054;  // 3.1 deg per frame
  EXPECT_TRUE(step({*input, body}, {}, *state).linePoints.empty());
}

TEST(LinePoints, WeightIsOneNearAndFallsToNothing) {
  const LineParams params;
  EXPECT_EQ(pointWeight(LinePointKind::line, 30, params), 1.0);
  EXPECT_EQ(pointWeight(LinePointKind::line, 70, params), 1.0);
  EXPECT_NEAR(pointWeight(LinePointKind::line, 210, params), 0.5, 1e-9);
  EXPECT_EQ(pointWeight(LinePointKind::line, 350, params), 0.0);
  EXPECT_EQ(pointWeight(LinePointKind::line, 500, params), 0.0);
}

}  // namespace
}  // namespace kelpie::vision
