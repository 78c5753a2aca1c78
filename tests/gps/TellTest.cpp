// SPDX-License-Identifier: Apache-2.0
// What the world model tells of the slow states beside the pose: landmarks off their places, and
// errors of the odometry.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/Extract.h"
#include "robot/core/fields/FieldCheck.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

constexpr LandmarkKind kKind = LandmarkKind::beaconBlueOnPink;

GpsState knownState() {
  GpsState state;
  state.pose.modes.push_back(PoseMode{});
  return state;
}

LandmarkOffset& offsetOf(LandmarkKind kind, GpsState& state) {
  return state.pose.offsets.landmarks[static_cast<std::size_t>(kind)];
}

TEST(Tell, ALandmarkFartherOffThanSevenCentimetresIsToldWithItsOffset) {
  GpsState state = knownState();
  offsetOf(LandmarkKind::goalYellow, state).x = 6.9;
  offsetOf(kKind, state).x = -6.0;
  offsetOf(kKind, state).y = 8.0;
  const MovedLandmarks told = extract(state, {}).movedLandmarks;
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].kind, kKind);
  EXPECT_EQ(told[0].offset.x, -6.0);
  EXPECT_EQ(told[0].offset.y, 8.0);
}

TEST(Tell, AllLandmarksAreToldByKindWhereAllWereMoved) {
  GpsState state = knownState();
  for (LandmarkOffset& offset : state.pose.offsets.landmarks) offset.y = 20.0;
  const MovedLandmarks told = extract(state, {}).movedLandmarks;
  ASSERT_EQ(told.size(), kLandmarkKindCount);
  for (std::size_t i = 0; i < told.size(); ++i)
    EXPECT_EQ(told[i].kind, static_cast<LandmarkKind>(i));
}

TEST(Tell, ErrorsOfTheOdometryComeWithTheirStandardDeviations) {
  GpsState state = knownState();
  state.pose.odometry.mean = {0.1, -0.2, 0.03};
  state.pose.odometry.covariance = {0.0004, 0, 0, 0, 0.0009, 0, 0, 0, 0.0001};
  const OdometryErrorEstimate told = extract(state, {}).odometryErrors;
  EXPECT_TRUE(told.present);
  EXPECT_EQ(told.scaleAhead, 0.1);
  EXPECT_EQ(told.scaleAside, -0.2);
  EXPECT_EQ(told.turnRate, 0.03);
  EXPECT_DOUBLE_EQ(told.scaleAheadSd, 0.02);
  EXPECT_DOUBLE_EQ(told.scaleAsideSd, 0.03);
  EXPECT_DOUBLE_EQ(told.turnRateSd, 0.01);
}

// Walks up-field for five seconds; the odometry tells nine tenths of the way.
struct Walk {
  sim::LocalisingRobot robot{{180, 270, maths::kPi / 2}, 1};
  WorldModel world;

  Walk() {
    robot.noise.landmarkShare = 0.02;
    robot.noise.landmarkHeading = 0.01;
    robot.believe({{180, 270}, Angle::deg(90)}, 5.0, Angle::deg(2));
  }
  void run() {
    for (int i = 0; i < 150; ++i) {
      robot.walk(0.5, 0.0, 0.008 * std::sin(i / 20.0));
      robot.input.odometry.forward *= 0.9;
      robot.lookAround(sim::panAt(i));
      robot.lookAtLines(sim::panAt(i));
      world = robot.step();
    }
  }
};

TEST(Tell, ABeaconThatWasPushedAsideIsTheOnlyOneTold) {
  Walk walk;
  for (body::Landmark& landmark : walk.robot.field.landmarks)
    if (landmark.kind == kKind) landmark.position.x += 14.0;
  walk.run();
  ASSERT_EQ(walk.world.movedLandmarks.size(), 1U);
  EXPECT_EQ(walk.world.movedLandmarks[0].kind, kKind);
  EXPECT_NEAR(walk.world.movedLandmarks[0].offset.x, 11.0, 4.0);
  EXPECT_NEAR(walk.world.movedLandmarks[0].offset.y, 0.0, 4.0);
  std::string why;
  EXPECT_TRUE(verify(walk.world, &why)) << why;
}

TEST(Tell, StepsThatAreLongerThanToldAreToldWithinTheirDoubt) {
  Walk walk;
  walk.run();
  const OdometryErrorEstimate& told = walk.world.odometryErrors;
  EXPECT_TRUE(walk.world.movedLandmarks.empty());
  EXPECT_GT(told.scaleAhead, 0.0);
  EXPECT_NEAR(told.scaleAhead, 1.0 / 0.9 - 1.0, 3.0 * told.scaleAheadSd);
  EXPECT_LT(told.scaleAheadSd, told.scaleAsideSd) << "it has not walked aside";
}

TEST(Tell, SwitchedOffNothingIsTold) {
  Walk walk;
  walk.robot.params.odometryErrors.use = false;
  walk.robot.params.landmarkOffsets.use = false;
  walk.run();
  EXPECT_FALSE(walk.world.odometryErrors.present);
  EXPECT_TRUE(walk.world.movedLandmarks.empty());
}

}  // namespace
}  // namespace kelpie::gps
