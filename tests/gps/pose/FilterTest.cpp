// SPDX-License-Identifier: Apache-2.0
// The laws of the filter's parts: prediction, merging, gates.
#include <gtest/gtest.h>

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Predict.h"
#include "tests/gps/pose/ModeAndMeasurement.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

TEST(Predict, JacobianMatchesDifferences) {
  const Odometry odometry{1.3, -0.4, Angle::rad(0.2), {}};
  const Pose2 pose{{100, 200}, Angle::rad(0.7)};
  const auto jacobian = movedJacobian(pose, odometry);
  constexpr double kStep = 1e-6;
  const Pose2 turned{pose.position, Angle::rad(0.7 + kStep)};
  const Point2<Field> d = moved(turned, odometry).position - moved(pose, odometry).position;
  EXPECT_NEAR(jacobian[2], d.x / kStep, 1e-5);
  EXPECT_NEAR(jacobian[5], d.y / kStep, 1e-5);
}

TEST(Predict, ForwardNoiseLiesAlongTheHeading) {
  PoseMode mode;
  mode.pose.heading = Angle::deg(30);
  predict(mode, {}, {9.0, 1.0, 0.0});
  // cos^2 30 * 9 + sin^2 30 * 1 = 7; (9 - 1) sin 30 cos 30 = 3.4641.
  EXPECT_NEAR(mode.covariance[0], 7.0, 1e-9);
  EXPECT_NEAR(mode.covariance[4], 3.0, 1e-9);
  EXPECT_NEAR(mode.covariance[1], 3.46410161514, 1e-9);
}

TEST(Modes, MergeAcrossTheHeadingWrapGoesTheShortWay) {
  PoseMode a = modeAt(100, 100, maths::kPi - 0.02), b = modeAt(104, 100, -maths::kPi + 0.02);
  a.weight = b.weight = 0.5;
  const PoseMode one = merged(a, b);
  EXPECT_NEAR(one.pose.heading.abs().rad(), maths::kPi, 1e-9);
  EXPECT_NEAR(one.pose.position.x, 102.0, 1e-9);
  EXPECT_NEAR(one.covariance[0], 120.0 + 4.0, 1e-9);  // the spread of the means
  EXPECT_NEAR(one.covariance[8], 0.05 + 0.02 * 0.02, 1e-9);
  EXPECT_NEAR(one.weight, 1.0, 1e-12);
}

TEST(Modes, SeedsOfADistanceAloneDoubtTheHeadingThatCameWithIt) {
  GpsParams params;
  params.field = *body::fieldDescription("2006");
  const auto headingVariance = [&params](bool useHeading) {
    GpsState state;
    Measurement m = seenAt({180, 540}, 150, 0.2);
    m.useHeading = useHeading;
    seedAround(m, params.field, params.modes, state.pose, state.counts);
    return state.pose.modes.empty() ? 0.0 : state.pose.modes[0].covariance[8];
  };
  EXPECT_NEAR(headingVariance(false) - headingVariance(true), 15.0 * 0.004, 1e-9);
}

TEST(Modes, BrokenModeIsRemovedAndTheLastOneReplaced) {
  sim::LocalisingRobot robot({180, 200, 1.0});
  robot.step();
  robot.state.pose.modes[0].pose.position.x = std::nan("");
  robot.state.pose.modes.push_back(modeAt(50, 60, 1.0));
  mergeAndPrune(robot.params.field, robot.params.modes, robot.state.pose, robot.state.counts);
  ASSERT_EQ(robot.state.pose.modes.size(), 1u);
  EXPECT_EQ(robot.state.pose.modes[0].pose.position.x, 50.0);
  robot.state.pose.modes[0].covariance[4] = -1.0;
  mergeAndPrune(robot.params.field, robot.params.modes, robot.state.pose, robot.state.counts);
  EXPECT_TRUE(robot.state.pose.lost);
  EXPECT_EQ(robot.state.pose.modes[0].pose.position.x, 180.0);
}

struct GateCase {
  LandmarkKind kind;
  double distance;
  bool used;
  bool distanceUsed;
};

class Gates : public testing::TestWithParam<GateCase> {};

TEST_P(Gates, HoldAtTheirBounds) {
  sim::LocalisingRobot robot({180, 270, 1.57});
  LandmarkPercept p = robot.look({GetParam().kind, {180, 540}});
  p.distance = GetParam().distance;
  const auto map = body::landmarksFor(robot.params.field, TeamColour::red);
  const auto m = measurement(p, map, robot.params.field, robot.params.gates, robot.state.counts);
  ASSERT_EQ(m.has_value(), GetParam().used);
  EXPECT_EQ(m && m->useDistance, GetParam().distanceUsed);
}

INSTANTIATE_TEST_SUITE_P(Landmarks, Gates,
                         testing::Values(GateCase{LandmarkKind::goalBlue, 69, false, false},
                                         GateCase{LandmarkKind::goalBlue, 71, true, true},
                                         GateCase{LandmarkKind::goalBlue, 249, true, true},
                                         GateCase{LandmarkKind::goalBlue, 251, true, false},
                                         GateCase{LandmarkKind::beaconBlueOnPink, 449, true, true},
                                         GateCase{LandmarkKind::beaconBlueOnPink, 451, true,
                                                  false}));

TEST(Landmarks, GoalCutByTheImageGivesItsHeadingAsFarAsItIsCertain) {
  sim::LocalisingRobot robot({180, 240, 1.57});
  LandmarkPercept p = robot.look({LandmarkKind::goalBlue, {180, 540}});
  p.rightEdgeCut = true;
  p.headingVariance = maths::square(Angle::deg(4.0).rad());
  const auto map = body::landmarksFor(robot.params.field, TeamColour::red);
  const auto m = measurement(p, map, robot.params.field, robot.params.gates, robot.state.counts);
  ASSERT_TRUE(m.has_value());
  EXPECT_TRUE(m->useHeading);
  EXPECT_GE(m->headingVariance, p.headingVariance);
  EXPECT_FALSE(m->useDistance);
}

}  // namespace
}  // namespace kelpie::gps
