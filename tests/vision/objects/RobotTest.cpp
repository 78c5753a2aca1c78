// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/PaintedRobot.h"
#include "vision/Refusal.h"
#include "vision/robot/RobotFinder.h"

namespace kelpie::vision {
namespace {

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

Painting robotAt(double x, double y, Paint team) {
  Painting p;
  p.noise = 3.0;
  addRobot(p, x, y, team);
  return p;
}

TEST(Robot, SeenFromItsSideIsOnePerceptInItsPlace) {
  for (const double y : {70.0, 110.0, 160.0, 200.0}) {
    const Seen seen = look(robotAt(10, y, kRedPaint), cameraAt(17, 0, -8));
    ASSERT_EQ(seen.percepts.robots.size(), 1U) << y;
    const RobotPercept& robot = seen.percepts.robots[0];
    EXPECT_EQ(robot.team, TeamColour::red);
    // The legs are in the plane of the walls; a body's half depth, 7 cm, is added.
    EXPECT_NEAR(robot.distance, std::hypot(10, y) + 7.0, 4.0 + 0.04 * y);
    EXPECT_NEAR(robot.heading.deg(), -std::atan2(12, y) * 57.3, 2.0);
    EXPECT_GT(robot.distanceVariance, 9.0);
  }
}

TEST(Robot, DarkBlueUniformIsTheBlueTeams) {
  const Seen seen = look(robotAt(-20, 100, kDarkBluePaint), cameraAt(17, 0, -8));
  ASSERT_EQ(seen.percepts.robots.size(), 1U);
  EXPECT_EQ(seen.percepts.robots[0].team, TeamColour::blue);
}

TEST(Robot, IsInTheSamePlaceInARolledImage) {
  const Seen seen = look(robotAt(0, 120, kRedPaint), cameraAt(17, 0, -8, 55));
  ASSERT_EQ(seen.percepts.robots.size(), 1U);
  EXPECT_NEAR(seen.percepts.robots[0].distance, 127, 10);
  EXPECT_NEAR(seen.percepts.robots[0].heading.deg(), -1.0, 2.0);
}

TEST(Robot, TwoOfOneTeamApartAreTwo) {
  Painting p = robotAt(-35, 130, kRedPaint);
  addRobot(p, 35, 130, kRedPaint);
  EXPECT_EQ(look(p, cameraAt(17, 0, -8)).percepts.robots.size(), 2U);
}

TEST(Robot, SpecksOfTheOtherTeamsColourOnItAreRefused) {
  Painting p = robotAt(0, 90, kDarkBluePaint);
  addWall(p, 0, 89.9, {3.0, 4.5, 10.0, 12.0}, kRedPaint);
  const Seen seen = look(p, cameraAt(17, 0, -8));
  ASSERT_EQ(seen.percepts.robots.size(), 1U);
  EXPECT_EQ(seen.percepts.robots[0].team, TeamColour::blue);
  EXPECT_EQ(refused(seen, Refusal::robotOnAnother), 1);
}

TEST(Robot, WithItsFeetBelowTheImageIsNear) {
  const Seen seen = look(robotAt(0, 50, kRedPaint), cameraAt(17, 0, 2));
  ASSERT_EQ(seen.percepts.robots.size(), 1U);
  EXPECT_NEAR(seen.percepts.robots[0].distance, 57, 20);
  EXPECT_GT(seen.percepts.robots[0].distanceVariance, 100.0);
}

TEST(Robot, RedTrousersBeyondTheCarpetAreRefused) {
  Painting p;
  p.carpetEnd = 160;
  p.noise = 3.0;
  p.walls.push_back({{-4, 200}, {6, 200}, 0, 8, kBlackPaint});
  p.walls.push_back({{-4, 200}, {6, 200}, 8, 20, kRedPaint});
  const Seen seen = look(p, cameraAt(17, 0, -8));
  EXPECT_TRUE(seen.percepts.robots.empty());
  EXPECT_GE(refused(seen, Refusal::robotAboveFieldEdge) + refused(seen, Refusal::robotOtherColour),
            1);
}

TEST(Robot, RedPatchHighUpIsRefused) {
  Painting p;
  addWall(p, 0, 120, {-5, 5, 60, 68}, kRedPaint);
  const Seen seen = look(p, cameraAt(17, 0, 5));
  EXPECT_TRUE(seen.percepts.robots.empty());
  EXPECT_EQ(refused(seen, Refusal::robotAboveHorizon), 1);
}

TEST(Robot, RedSpeckIsTooSmall) {
  Painting p;
  addWall(p, 0, 150, {-0.8, 0.8, 9, 10.5}, kRedPaint);
  const Seen seen = look(p, cameraAt(17, 0, -8));
  EXPECT_TRUE(seen.percepts.robots.empty());
  EXPECT_GE(refused(seen, Refusal::robotTooSmall), 1);
}

TEST(Robot, RedWallIsTooLarge) {
  Painting p;
  addWall(p, 0, 120, {-25, 25, 8, 20}, kRedPaint);
  const Seen seen = look(p, cameraAt(17, 0, -8));
  EXPECT_TRUE(seen.percepts.robots.empty());
  EXPECT_EQ(refused(seen, Refusal::robotSize), 1);
}

TEST(Robot, BeyondTheLimitIsRefused) {
  VisionParams params;
  params.robot.maxDistance = 100;
  const Seen seen = look(robotAt(0, 150, kRedPaint), cameraAt(17, 0, -8), params);
  EXPECT_TRUE(seen.percepts.robots.empty());
  EXPECT_GE(refused(seen, Refusal::robotTooFar), 1);
}

}  // namespace
}  // namespace kelpie::vision
