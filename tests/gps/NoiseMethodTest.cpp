// SPDX-License-Identifier: Apache-2.0
// The three ways to treat a sighting that a mode did not predict (thesis 2004 section 2.2.3).
#include <gtest/gtest.h>

#include "gps/pose/Modes.h"
#include "tools/sim/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

sim::LocalisingRobot localised(NoiseMethod method) {
  sim::LocalisingRobot robot({180, 250, 1.5});
  robot.params.modes.noiseMethod = method;
  robot.params.initialPose = {true, {{180, 250}, Angle::rad(1.5)}, 5.0, Angle::deg(3)};
  robot.step();
  return robot;
}

// A beacon 120 deg beside where it should be.
void seeFalsely(sim::LocalisingRobot& robot) {
  const auto landmarks = body::landmarksFor(robot.params.field, robot.input.game.team);
  LandmarkPercept p = robot.look(landmarks[3], false);
  p.heading = p.heading + Angle::deg(120);
  robot.percepts.landmarks.push_back(p);
  robot.walk(0, 0, 0);
  robot.step();
  robot.percepts.landmarks.clear();
}

TEST(NoiseMethod, RefusingKeepsThePlaceAndGrows) {
  sim::LocalisingRobot robot = localised(NoiseMethod::refuse);
  const double before = robot.state.pose.modes[0].covariance[0];
  seeFalsely(robot);
  ASSERT_EQ(robot.state.pose.modes.size(), 1U);
  EXPECT_NEAR(robot.state.pose.modes[0].covariance[0], before + 100.0, 5.0);
  EXPECT_LT(robot.error(robot.step()), 0.5);
}

TEST(NoiseMethod, SplittingKeepsAnUncorrectedCopyInFront) {
  for (const NoiseMethod method : {NoiseMethod::split, NoiseMethod::splitAndWide}) {
    sim::LocalisingRobot robot = localised(method);
    seeFalsely(robot);
    EXPECT_GE(robot.state.pose.modes.size(), 2U);
    EXPECT_LT(robot.error(robot.step()), 0.5);
  }
}

TEST(NoiseMethod, OnlyTheThirdHasAWideMode) {
  const auto widest = [](NoiseMethod method) {
    sim::LocalisingRobot robot = localised(method);
    seeFalsely(robot);
    double most = 0.0;
    for (const PoseMode& mode : robot.state.pose.modes) most = std::max(most, mode.covariance[0]);
    return most;
  };
  EXPECT_LT(widest(NoiseMethod::split), 400.0);
  EXPECT_GT(widest(NoiseMethod::splitAndWide), 1000.0);
}

}  // namespace
}  // namespace kelpie::gps
