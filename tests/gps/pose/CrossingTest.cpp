// SPDX-License-Identifier: Apache-2.0
// Two landmarks that nobody predicted give the place of a robot that was carried.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/pose/Crossing.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Predict.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

// A robot that is sure of kPose and really stands elsewhere.
struct Carried {
  Pose2 really{{250.0, 400.0}, Angle::deg(-120.0)};
  PoseState state;

  Carried() {
    PoseMode mode;
    mode.pose = kPose;
    mode.weight = 1.0;
    mode.covariance = {4, 0, 0, 0, 4, 0, 0, 0, 0.0004};
    state.modes.push_back(mode);
    state.lost = false;
  }
  Measurement of(std::size_t landmark) const {
    Measurement m;
    m.landmark = field2006().landmarks[landmark].position;
    const Point2<Robot> place = robotFromField(really, m.landmark);
    m.useDistance = m.useHeading = true;
    m.distance = place.norm();
    m.heading = bearing(place);
    m.distanceVariance = 100.0;
    m.headingVariance = 0.0004;
    return m;
  }
  void see(std::size_t landmark) { cross(of(landmark), field2006(), {}, {}, state); }
  double errorOfLast() const {
    return distance(state.modes[state.modes.size() - 1].pose.position, really.position);
  }
};

TEST(Crossing, OfTwoLandmarksIsWhereTheRobotStands) {
  Carried robot;
  robot.see(0);
  EXPECT_EQ(robot.state.modes.size(), 1U);
  robot.see(2);
  ASSERT_EQ(robot.state.modes.size(), 2U);
  EXPECT_LT(robot.errorOfLast(), 1.0);
  EXPECT_LT(robot.state.modes[1].weight, 0.1);
}

TEST(Crossing, WaitsForTheSecondWhileTheRobotWalksAndTurns) {
  Carried robot;
  robot.see(0);
  for (int i = 0; i < 60; ++i) {
    const Odometry step{0.8, 0.1, Angle::deg(1.0), {}};
    robot.really = moved(robot.really, step);
    moveCrossing(step, kFrameSeconds, robot.state.surprising);
  }
  robot.see(2);
  ASSERT_EQ(robot.state.modes.size(), 2U);
  EXPECT_LT(robot.errorOfLast(), 1.0);
}

TEST(Crossing, OfOneLandmarkSeenTwiceThereIsNone) {
  Carried robot;
  robot.see(0);
  robot.see(0);
  EXPECT_EQ(robot.state.modes.size(), 1U);
}

TEST(Crossing, APredictedLandmarkEndsTheSurprise) {
  Carried robot;
  robot.see(0);
  robot.really = kPose;
  robot.see(1);
  robot.really = {{250.0, 400.0}, Angle::deg(-120.0)};
  robot.see(2);
  EXPECT_EQ(robot.state.modes.size(), 1U);
}

TEST(Crossing, OffTheCarpetIsNone) {
  Carried robot;
  robot.really = {{600.0, 400.0}, Angle::deg(180.0)};
  robot.see(0);
  robot.see(2);
  EXPECT_EQ(robot.state.modes.size(), 1U);
}

TEST(Crossing, ALongAgoSurpriseIsForgotten) {
  Carried robot;
  robot.see(0);
  moveCrossing({}, CrossingParams{}.seconds + 1.0, robot.state.surprising);
  robot.see(2);
  EXPECT_EQ(robot.state.modes.size(), 1U);
}

}  // namespace
}  // namespace kelpie::gps
