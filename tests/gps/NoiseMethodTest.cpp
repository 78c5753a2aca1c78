// SPDX-License-Identifier: Apache-2.0
// What becomes of a sighting that no mode predicted: methods 2 and 3 of thesis 2004 section 2.2.3,
// and beginning anew. Method 1 is a baseline of the experiments.
#include <gtest/gtest.h>

#include "gps/pose/Modes.h"
#include "tests/gps/FalseSighting.h"

namespace kelpie::gps {
namespace {

sim::LocalisingRobot localised(double wideWeight) {
  sim::LocalisingRobot robot({180, 250, 1.5});
  robot.params.modes.wideWeight = wideWeight;
  robot.believe({{180, 250}, Angle::rad(1.5)}, 5.0, Angle::deg(3));
  robot.step();
  return robot;
}

TEST(NoiseMethod, SplittingKeepsAnUncorrectedCopyInFront) {
  for (const double wideWeight : {0.0, 1e-12}) {
    sim::LocalisingRobot robot = localised(wideWeight);
    seeFalsely(robot);
    EXPECT_GE(robot.state.pose.modes.size(), 2U);
    EXPECT_LT(robot.error(robot.step()), 0.5);
  }
}

TEST(NoiseMethod, OnlyTheThirdHasAWideMode) {
  const auto widest = [](double wideWeight) {
    sim::LocalisingRobot robot = localised(wideWeight);
    seeFalsely(robot);
    double most = 0.0;
    for (const PoseMode& mode : robot.state.pose.modes) most = std::max(most, mode.covariance[0]);
    return most;
  };
  EXPECT_LT(widest(0.0), 400.0);
  EXPECT_GT(widest(1e-12), 1000.0);
}

TEST(NoiseMethod, ManyFalseSightingsInARowBeginAnewUnlessForbidden) {
  const auto lostWithin = [](std::uint32_t maxUnexplained) {
    sim::LocalisingRobot robot = localised(0.0);
    robot.params.modes.maxUnexplained = maxUnexplained;
    bool lost = false;
    for (int i = 0; i < 15; ++i) {
      seeFalsely(robot);
      lost = lost || robot.state.pose.lost;
    }
    return lost;
  };
  EXPECT_TRUE(lostWithin(5));
  EXPECT_FALSE(lostWithin(0));
}

}  // namespace
}  // namespace kelpie::gps
