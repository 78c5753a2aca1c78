// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/vision/PaintedRobot.h"
#include "vision/Refusal.h"
#include "vision/robot/Obstacles.h"

namespace kelpie::vision {
namespace {

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

Painting boxAt(double x, double y, Paint paint, double high = 15.0) {
  Painting p;
  p.noise = 3.0;
  addWall(p, x, y, {-8, 8, 0, high}, paint);
  return p;
}

TEST(Obstacles, FeetOfADarkThingAreItsPlaceOnTheGround) {
  const Seen seen = look(boxAt(0, 80, kBlackPaint), cameraAt(17, 0, -15));
  ASSERT_GE(seen.percepts.obstacles.size(), 3U);
  for (const ObstaclePoint& point : seen.percepts.obstacles) {
    EXPECT_NEAR(point.position.y, 80, 6);
    EXPECT_LT(std::abs(point.position.x), 11);
  }
  EXPECT_GE(seen.percepts.obstaclesAhead, 10);
}

TEST(Obstacles, ARobotsGreyLegsCountOnlyIfWanted) {
  Painting p;
  addRobot(p, 0, 70, kRedPaint);
  VisionParams params;
  EXPECT_GE(look(p, cameraAt(17, 0, -15), params).percepts.obstaclesAhead, 4);
  params.obstacle.greyCounts = false;
  EXPECT_EQ(look(p, cameraAt(17, 0, -15), params).percepts.obstaclesAhead, 0);
}

TEST(Obstacles, BesideOrBeyondTheBoxIsNotAhead) {
  const Seen beside = look(boxAt(45, 80, kBlackPaint), cameraAt(17, -20, -15));
  EXPECT_FALSE(beside.percepts.obstacles.empty());
  EXPECT_EQ(beside.percepts.obstaclesAhead, 0);
  const Seen beyond = look(boxAt(0, 140, kBlackPaint), cameraAt(17, 0, -8));
  EXPECT_FALSE(beyond.percepts.obstacles.empty());
  EXPECT_EQ(beyond.percepts.obstaclesAhead, 0);
}

TEST(Obstacles, AShadowOnTheCarpetIsNone) {
  Painting p;
  p.lineAt = 90;
  p.carpet = kGreenPaint;
  addWall(p, 0, 80, {-10, 10, 0, 2.0}, kBlackPaint);  // flat: green goes on right above it
  const Seen seen = look(p, cameraAt(17, 0, -15));
  EXPECT_EQ(seen.percepts.obstaclesAhead, 0);
  EXPECT_GE(refused(seen, Refusal::obstacleGreenAbove), 5);
}

TEST(Obstacles, WhatIsDarkBeyondTheFieldEdgeIsNone) {
  Painting p = boxAt(0, 180, kBlackPaint, 60);
  p.carpetEnd = 150;
  const Seen seen = look(p, cameraAt(17, 0, -8));
  ASSERT_EQ(seen.percepts.fieldEdges.size(), 1U);
  EXPECT_TRUE(seen.percepts.obstacles.empty());
  EXPECT_GE(refused(seen, Refusal::obstacleAboveFieldEdge), 1);
}

TEST(Obstacles, EmptyFieldWithALineAndABallHasNone) {
  Painting p;
  p.noise = 3.0;
  p.lineAt = 70;
  p.balls.push_back({10, 100});
  const Seen seen = look(p, cameraAt(17, 0, -15));
  EXPECT_TRUE(seen.percepts.obstacles.empty());
}

TEST(Obstacles, WhatIsDarkIsJudgedByTheCarpetAround) {
  const auto ahead = [](double carpetY, double boxY) {
    Painting p = boxAt(0, 80, {boxY, 126, 128});
    p.carpet.y = carpetY;
    return look(p, cameraAt(17, 0, -15)).percepts.obstaclesAhead;
  };
  EXPECT_GE(ahead(77, 30), 10);
  EXPECT_GE(ahead(50, 20), 10);
  EXPECT_EQ(ahead(50, 32), 0) << "a shade darker than a dark carpet";
  EXPECT_GE(ahead(100, 38), 10);
}

TEST(Obstacles, AtMostFivePixelsOfALineCount) {
  VisionParams params;  // all of them ahead: the box's sides lean, their pixels seem far behind it
  params.obstacle.aheadSide = params.obstacle.aheadFar = 200;
  const Seen five = look(boxAt(0, 50, kBlackPaint, 30), cameraAt(17, 0, -20), params);
  params.obstacle.maxPerLine = 1;
  const Seen one = look(boxAt(0, 50, kBlackPaint, 30), cameraAt(17, 0, -20), params);
  ASSERT_GE(one.percepts.obstacles.size(), 8U);  // of 16 cm at 42 cm and a line every 8 px
  EXPECT_EQ(one.percepts.obstaclesAhead, one.percepts.obstacles.size());
  EXPECT_EQ(five.percepts.obstaclesAhead, 5 * one.percepts.obstaclesAhead);
}

}  // namespace
}  // namespace kelpie::vision
