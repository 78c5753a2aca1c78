// SPDX-License-Identifier: Apache-2.0
// Belief of the exposure's moment, brought to that of the image's stamp.
#include <gtest/gtest.h>

#include "gps/Ahead.h"
#include "gps/Localiser.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

// A frame of 1/30 s, in which the robot walked 1 cm ahead and turned 3 deg.
FrameInput walkingFrame(double lag) {
  FrameInput input;
  input.elapsed = 1.0 / 30.0;
  input.odometry = {1.0, 0.0, Angle::deg(3.0), {}};
  input.imageLag.seconds = lag;
  return input;
}

TEST(Ahead, AnImageOfOneFrameAgoIsFollowedByAFramesWay) {
  const Odometry step = sinceExposure(walkingFrame(1.0 / 30.0));
  EXPECT_NEAR(step.forward, 1.0, 1e-9);
  EXPECT_NEAR(step.turn.deg(), 3.0, 1e-9);
}

TEST(Ahead, AnImageAsOldAsItsStampIsFollowedByNone) {
  const Odometry step = sinceExposure(walkingFrame(0.0));
  EXPECT_EQ(step.forward, 0.0);
  EXPECT_EQ(step.turn.rad(), 0.0);
}

TEST(Ahead, TheFirstFrameHasNoRate) {
  FrameInput input = walkingFrame(0.03);
  input.elapsed = 0.0;
  EXPECT_EQ(sinceExposure(input).forward, 0.0);
}

TEST(Ahead, TheBallStaysOnTheFieldAndTurnsRelativeToTheRobot) {
  WorldModel world;
  world.pose = kPose;
  world.ball.present = true;
  world.ball.relative = {0.0, 100.0};
  world.ball.position = fieldFromRobot(world.pose, world.ball.relative);
  bringForward({0.0, 0.0, Angle::deg(10.0), {}}, world);
  EXPECT_NEAR((world.pose.heading - kPose.heading).deg(), 10.0, 1e-9);
  EXPECT_NEAR(world.ball.heading.deg(), -10.0, 1e-9);
  const Point2<Field> seen = fieldFromRobot(world.pose, world.ball.relative);
  EXPECT_NEAR(distance(seen, world.ball.position), 0.0, 1e-9);
}

TEST(Ahead, APoseOfALaggingImageHasTurnedOnInTheWorldModel) {
  GpsParams params;
  params.field = field2006();
  params.initialPose = {true, kPose, 1.0, Angle::deg(1.0)};
  const auto headingOf = [&](double lag) {
    GpsState state;
    const FrameInput input = walkingFrame(lag);
    return step({input, {}, {}}, params, state).pose.heading;
  };
  EXPECT_NEAR((headingOf(1.0 / 30.0) - headingOf(0.0)).deg(), 3.0, 1e-6);
}

}  // namespace
}  // namespace kelpie::gps
