// SPDX-License-Identifier: Apache-2.0
// The fitted peaks of the thesis' mode sampling (2004 equations 3.24 to 3.26), and its update.
#include <gtest/gtest.h>

#include "gps/pose/Modes.h"
#include "tools/experiments/baselines/ModeSampling.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

double gauss(double x, double top, double sd) {
  return 0.7 * std::exp(-0.5 * (x - top) * (x - top) / (sd * sd));
}

TEST(ModeSampling, ThreePointsGiveTheGaussianThatTheyLieOn) {
  for (const double top : {-0.4, 0.0, 0.3}) {
    for (const double sd : {0.5, 1.0, 3.0}) {
      const auto peak = fitPeak(gauss(-1, top, sd), gauss(0, top, sd), gauss(1, top, sd));
      ASSERT_TRUE(peak);
      EXPECT_NEAR(peak->mean, top, 1e-9);
      EXPECT_NEAR(peak->sd, sd, 1e-9);
    }
  }
}

TEST(ModeSampling, TwoPointsGiveTheGaussianWithItsTopAtTheEdge) {
  const auto peak = fitEdgePeak(gauss(0, 1.0, 0.8), gauss(1, 1.0, 0.8));
  ASSERT_TRUE(peak);
  EXPECT_EQ(peak->mean, 1.0);
  EXPECT_NEAR(peak->sd, 0.8, 1e-9);
}

TEST(ModeSampling, FlatOrHollowOrBrokenValuesGiveNone) {
  EXPECT_FALSE(fitPeak(0.5, 0.5, 0.5));
  EXPECT_FALSE(fitPeak(0.6, 0.5, 0.6));
  EXPECT_FALSE(fitPeak(0.0, 0.5, 0.1));
  EXPECT_FALSE(fitEdgePeak(0.5, 0.5));
  EXPECT_FALSE(fitEdgePeak(-1.0, 0.5));
}

TEST(ModeSampling, MovesTowardsTheTruePose) {
  double before = 0.0;
  double after = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    sim::LocalisingRobot robot({180, 130, -1.4}, seed);
    robot.params.initialPose = {true, {{190, 122}, Angle::rad(-1.35)}, 10.0, Angle::deg(5)};
    robot.params.lines.update.use = LineUse::off;
    before += robot.error(robot.step());
    for (int frame = 0; frame < 20; ++frame) {
      robot.lookAtLines(0.0);
      GpsState& state = robot.state;
      ASSERT_TRUE(updateBySampling(seenLines(robot.percepts.linePoints, {}), {},
                                   state.lines.features, {}, state.pose.modes));
      mergeAndPrune(robot.params.field, robot.params.modes, state.pose, state.counts);
    }
    const Pose2 pose = robot.state.pose.modes[0].pose;
    after += std::hypot(pose.position.x - 180, pose.position.y - 130);
  }
  EXPECT_LT(after, 0.5 * before);
}

}  // namespace
}  // namespace kelpie::gps
