// SPDX-License-Identifier: Apache-2.0
// The carpet's borders in painted images, from pixels to rows.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/Painting.h"
#include "vision/Scene.h"
#include "vision/edge/FieldEdge.h"

namespace kelpie::vision {
namespace {

// Row of the ground at a distance ahead of the camera, which is 16 cm high and looks 5 deg down.
double groundRow(double ahead) {
  return 80 + 192 * std::tan(std::atan2(16.0, ahead) - 5 * 3.14159265 / 180);
}

TEST(FieldEdge, IsWhereTheCarpetEnds) {
  Painting p;
  p.carpetEnd = 200;
  p.noise = 3.0;
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_EQ(seen.percepts.fieldEdges.size(), 1U);
  // 192 cm ahead of the camera.
  EXPECT_NEAR(seen.percepts.fieldEdges[0].atLeft, groundRow(192), 1.0);
  EXPECT_NEAR(seen.percepts.fieldEdges[0].atRight, groundRow(192), 1.0);
  EXPECT_GT(seen.percepts.fieldEdges[0].support, 45.0);
}

TEST(FieldEdge, NoneIsClaimedWhenAllIsGreenOrNothingIs) {
  EXPECT_TRUE(look({}, cameraAt(16, 0, -45)).percepts.fieldEdges.empty());
  Painting bare;
  bare.carpet = kFloorPaint;
  EXPECT_TRUE(look(bare, cameraAt(16, 0, -5)).percepts.fieldEdges.empty());
}

TEST(FieldEdge, WhiteLineOnTheFieldIsNotTheEdge) {
  Painting p;
  p.carpetEnd = 200;
  p.lineAt = 90;
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_EQ(seen.percepts.fieldEdges.size(), 1U);
  EXPECT_LT(seen.percepts.fieldEdges[0].atLeft, 84.0);
}

TEST(FieldEdge, OrangeThatFillsTheUpperImageIsNotTheEdge) {
  Painting p;
  p.walls.push_back({{-60, 35}, {60, 35}, 0, 60, kOrangePaint});
  EXPECT_TRUE(look(p, cameraAt(16, 0, -45)).percepts.fieldEdges.empty());
}

TEST(FieldEdge, GoalAndBallBeforeItDoNotBendIt) {
  Painting p;
  p.carpetEnd = 230;
  addGoal(p, 0, 200, kBluePaint);
  p.balls.push_back({40, 120});
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_EQ(seen.percepts.fieldEdges.size(), 1U);
  EXPECT_NEAR(seen.percepts.fieldEdges[0].atLeft, groundRow(222), 1.5);
  EXPECT_NEAR(seen.percepts.fieldEdges[0].atRight, groundRow(222), 1.5);
}

TEST(FieldEdge, LeansWithARolledImage) {
  Painting p;
  p.carpetEnd = 150;
  for (const double roll : {-60.0, -30.0, 30.0, 60.0}) {
    const CameraPose camera = cameraAt(16, 0, -5, roll);
    const Seen seen = look(p, camera);
    ASSERT_EQ(seen.percepts.fieldEdges.size(), 1U) << roll;
    // The middle of the image looks 5 deg down, the edge is 1.4 deg lower.
    const double below = groundRow(142) - 80;
    const double row = fieldEdgeRow(seen.percepts.fieldEdges, 104.0);
    EXPECT_NEAR(row, 80 + below / std::cos(roll * 3.14159265 / 180), 2.0) << roll;
  }
}

TEST(FieldEdge, OfSeveralEdgesTheLowestBoundsTheCarpet) {
  FieldEdges edges;
  EXPECT_LT(fieldEdgeRow(edges, 104.0), -1e5);
  edges.push_back({20.0, 20.0, 30.0, 1.0});
  edges.push_back({-40.0, 100.0, 20.0, 1.0});
  EXPECT_DOUBLE_EQ(fieldEdgeRow(edges, 0.0), 20.0);
  EXPECT_DOUBLE_EQ(fieldEdgeRow(edges, 208.0), 100.0);
}

}  // namespace
}  // namespace kelpie::vision
