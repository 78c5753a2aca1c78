// SPDX-License-Identifier: Apache-2.0
// Landmarks and lines in one update: the same as two where all is linear, with one copy.
#include <gtest/gtest.h>

#include "gps/lines/JointUpdate.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Update.h"
#include "tools/sim/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

PoseMode someMode() {
  PoseMode mode;
  mode.weight = 0.7;
  mode.pose = {{150.0, 220.0}, Angle::deg(170.0)};
  Matrix3 c;
  c << 120, 15, 0.4, 15, 80, -0.3, 0.4, -0.3, 0.05;
  setCovariance(mode, c);
  return mode;
}

PoseObservation poseSeen(double x, double y, double deg, double scale) {
  Matrix3 y3;
  y3 << 0.05, 0.01, 0.2, 0.01, 0.02, 0.1, 0.2, 0.1, 30.0;
  return {{{x, y}, Angle::deg(deg)}, scale * y3};
}

void expectSame(const PoseMode& a, const PoseMode& b) {
  EXPECT_NEAR(a.weight / b.weight, 1.0, 1e-9);
  EXPECT_NEAR(distance(a.pose.position, b.pose.position), 0.0, 1e-9);
  EXPECT_NEAR((a.pose.heading - b.pose.heading).rad(), 0.0, 1e-11);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a.covariance[i], b.covariance[i], 1e-8);
}

TEST(JointUpdate, OneUpdateIsTwoWhereAllIsLinear) {
  const PoseObservation first = poseSeen(158.0, 214.0, -179.0, 1.0);
  const PoseObservation second = poseSeen(147.0, 226.0, 165.0, 0.4);
  PoseMode two = someMode();
  correct(two, first);
  correct(two, second);
  InformationSum information;
  information.add(someMode(), first);
  information.add(someMode(), second);
  expectSame(corrected(someMode(), information, false), two);
}

TEST(JointUpdate, OneLandmarkCorrectsAsInItsOwnUpdate) {
  const Measurement seen{{0.0, 405.0}, true, true, 260.0, Angle::deg(-30.0), 400.0, 0.004};
  for (const bool weighByDeterminant : {false, true}) {
    PoseMode alone = someMode();
    update(alone, seen, weighByDeterminant);
    InformationSum information;
    information.add(someMode(), seen, someMode().pose);
    expectSame(corrected(someMode(), information, weighByDeterminant), alone);
  }
}

// Variance 4 along x, seen at +2 with variance 4: half the way, half the variance,
// S = exp(-4 / (2 * 8)).
TEST(JointUpdate, AHandMadeCase) {
  PoseMode mode;
  mode.weight = 1.0;
  mode.covariance = {4, 0, 0, 0, 4, 0, 0, 0, 0.01};
  PoseObservation seen;
  seen.pose = {{2.0, 0.0}, Angle()};
  seen.information = Vector3(0.25, 0.0, 0.0).asDiagonal();
  InformationSum information;
  information.add(mode, seen);
  const PoseMode after = corrected(mode, information, false);
  EXPECT_NEAR(after.pose.position.x, 1.0, 1e-12);
  EXPECT_NEAR(after.pose.position.y, 0.0, 1e-12);
  EXPECT_NEAR(after.covariance[0], 2.0, 1e-12);
  EXPECT_NEAR(after.covariance[4], 4.0, 1e-12);
  EXPECT_NEAR(after.weight, std::exp(-0.25), 1e-12);
}

// Where all is linear it does not matter where it is linearised: a heading far from the landmark.
TEST(JointUpdate, LinearisedElsewhereTheSameObservationSaysNearlyTheSame) {
  Measurement seen{{1e6, 220.0}, false, true, 1e6, Angle::deg(-165.0), 1.0, 0.004};
  InformationSum here;
  here.add(someMode(), seen, someMode().pose);
  InformationSum there;
  there.add(someMode(), seen, {{170.0, 200.0}, Angle::deg(155.0)});
  const PoseMode a = corrected(someMode(), here, false);
  const PoseMode b = corrected(someMode(), there, false);
  EXPECT_NEAR((a.pose.heading - b.pose.heading).rad(), 0.0, 1e-4);
  EXPECT_NEAR(a.weight, b.weight, 1e-4);
}

TEST(JointUpdate, AModeOnALandmarkKeepsItsPlaceAndLosesItsWeight) {
  const Measurement seen{someMode().pose.position, true, true, 50.0, Angle(), 400.0, 0.004};
  InformationSum information;
  information.add(someMode(), seen, someMode().pose);
  const PoseMode after = corrected(someMode(), information, false);
  EXPECT_EQ(after.pose.position.x, someMode().pose.position.x);
  EXPECT_LT(after.weight, 1e-19);
}

TEST(JointUpdate, AFrameSplitsEachModeOnce) {
  sim::LocalisingRobot robot({150.0, 220.0, 2.9}, 3);
  robot.params.modes.noiseMethod = NoiseMethod::split;
  robot.state.lines.features.build(robot.params.field);
  robot.state.pose.modes.push_back(someMode());
  const LinesState& lines = robot.state.lines;
  const PaintedField field{robot.params.field, lines.features, lines.painted};
  const JointParams params{robot.params.modes, robot.params.lines.update};
  Sightings both;
  both.landmarks.push_back({{0.0, 405.0}, true, true, 240.0, Angle::deg(-40.0), 400.0, 0.004});
  both.landmarks.push_back({{0.0, 135.0}, true, true, 172.0, Angle::deg(40.0), 400.0, 0.004});
  EXPECT_TRUE(updateJointly(both, field, params, robot.state.pose, robot.state.counts));
  EXPECT_EQ(robot.state.pose.modes.size(), 2U);
  EXPECT_FALSE(updateJointly({}, field, params, robot.state.pose, robot.state.counts));
}

TEST(JointUpdate, AWalkingRobotFindsItsPlaceWithLandmarksAndLines) {
  sim::LocalisingRobot robot({140.0, 180.0, 1.2}, 11);
  robot.params.lines.update.combine = LineCombine::joint;
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

}  // namespace
}  // namespace kelpie::gps
