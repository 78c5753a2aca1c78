// SPDX-License-Identifier: Apache-2.0
// A penalty that ends: the robot stands beside the half-way line, on one of two sides.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/pose/Return.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

// Believed to lie beside the field while it was penalised, and put back at the right side line.
sim::LocalisingRobot putBack(Point2<Field> place, bool use = true) {
  sim::LocalisingRobot robot({place.x, place.y, maths::kPi}, 5);
  robot.params.initialPose.present = true;
  robot.params.initialPose.pose = {{-20.0, 240.0}, Angle::deg(0.0)};
  robot.params.initialPose.positionSd = 5.0;
  robot.params.afterPenalty.use = use;
  robot.input.game.state = PlayState::playing;
  robot.input.game.penalised = true;
  for (int i = 0; i < 10; ++i) static_cast<void>(robot.step());
  robot.input.game.penalised = false;
  return robot;
}

double errorAfter(int frames, sim::LocalisingRobot robot) {
  WorldModel world;
  for (int i = 0; i < frames; ++i) {
    robot.lookAround(sim::panAt(i));
    world = robot.step();
  }
  return robot.error(world);
}

TEST(Return, WhoComesBackBelievesInBothEndsOfTheHalfWayLine) {
  const WorldModel world = putBack({345.0, 270.0}).step();
  ASSERT_EQ(world.modes.size(), 2U);
  double sides = 0.0;
  for (const PoseMode& mode : world.modes) {
    EXPECT_EQ(mode.pose.position.y, 270.0);
    EXPECT_EQ(std::fabs(mode.pose.position.x - 180.0), 165.0);
    EXPECT_GT(mode.pose.heading.cos() * (180.0 - mode.pose.position.x), 0.0);  // looks inwards
    sides += mode.pose.position.x;
  }
  EXPECT_EQ(sides, 360.0);
}

TEST(Return, ALandmarkTellsTheSideSoonerThanASearchWould) {
  EXPECT_LT(errorAfter(1, putBack({345.0, 270.0})), 15.0);
  EXPECT_GT(errorAfter(1, putBack({345.0, 270.0}, false)), 100.0);
}

TEST(Return, WhoIsPutElsewhereIsFoundAllTheSame) {
  EXPECT_LT(errorAfter(300, putBack({100.0, 120.0})), 15.0);
}

TEST(Return, APenaltyThatGoesOnChangesNothing) {
  sim::LocalisingRobot robot = putBack({345.0, 270.0});
  robot.input.game.penalised = true;
  EXPECT_NEAR(robot.step().pose.position.x, -20.0, 1e-6);
}

TEST(Return, NorDoesOneThatEndsBeforeTheMatch) {
  sim::LocalisingRobot robot = putBack({345.0, 270.0});
  robot.input.game.state = PlayState::initial;
  EXPECT_NEAR(robot.step().pose.position.x, -20.0, 1e-6);
}

}  // namespace
}  // namespace kelpie::gps
