// SPDX-License-Identifier: Apache-2.0
// The localisers that experiments compare the robot's with.
#include <gtest/gtest.h>

#include "tests/gps/FalseSighting.h"
#include "tools/experiments/baselines/PoseVariants.h"

namespace kelpie::gps {
namespace {

double growthOf(Localise localise) {
  sim::LocalisingRobot robot({180, 250, 1.5});
  robot.localise = localise;
  robot.believe({{180, 250}, Angle::rad(1.5)}, 5.0, Angle::deg(3));
  robot.step();
  const double before = robot.state.pose.modes[0].covariance[0];
  seeFalsely(robot);
  EXPECT_EQ(robot.state.pose.modes.size(), 1U);
  EXPECT_LT(robot.error(robot.step()), 0.5);
  return robot.state.pose.modes[0].covariance[0] - before;
}

TEST(PoseVariants, RefusingKeepsThePlaceAndGrows) {
  EXPECT_NEAR(growthOf(stepRefusing), 100.0, 5.0);
  EXPECT_NEAR(growthOf(stepRefusingSlowly), 4.0, 1.0);
}

TEST(PoseVariants, EachFindsThePlaceOfAWalkingRobot) {
  for (const Localise localise :
       {stepRefusing, stepRefusingSlowly, stepJointly, stepByDeterminant, stepWithSymmetry}) {
    sim::LocalisingRobot robot({140.0, 180.0, 1.2}, 11);
    robot.localise = localise;
    double cm = 0.0;
    for (int frame = 0; frame < 150; ++frame) {
      robot.walk(0.7, 0.0, 0.004);
      robot.lookAround(sim::panAt(frame));
      robot.lookAtLines(sim::panAt(frame));
      const WorldModel world = robot.step();
      if (frame >= 90) cm += robot.error(world) / 60.0;
    }
    EXPECT_LT(cm, 4.0);
  }
}

}  // namespace
}  // namespace kelpie::gps
