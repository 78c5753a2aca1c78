// SPDX-License-Identifier: Apache-2.0
// The scale of the focal length: found from where landmarks lie in the image and how far away they
// look, and fed back into the reading of the next image.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/camera/Focal.h"
#include "gps/pose/PoseUpdate.h"
#include "robot/core/Random.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

// A robot whose head looks round, and whose lens is so many times as long as its parameters say.
struct Looking {
  FocalParams params;
  FocalScale focal = startingFocal({});
  PoseMode mode;
  FrameInput input;
  Percepts percepts;
  CameraPose camera;
  bool distances = true;

  Looking() {
    mode.pose = kPose;
    mode.covariance = {25, 0, 0, 0, 25, 0, 0, 0, 0.0003};
  }
  void frames(int count, double truth, double off = 0.0) {
    Random random(7);
    for (int i = 0; i < count; ++i) {
      const Angle pan = Angle::deg(30.0 * std::sin(0.1 * i));
      camera.axes = {pan.cos(), 0, -pan.sin(), pan.sin(), 0, pan.cos(), 0, -1, 0};
      input.focalScale = focal;
      for (const Point2<Field> place : {Point2<Field>{250.0, 400.0}, Point2<Field>{380.0, 240.0}})
        see(place, pan, truth / focal.ratio, off, random);
    }
  }
  void see(Point2<Field> place, Angle pan, double stretched, double off, Random& random) {
    const Expectation e = expected(kPose, place);
    Measurement seen;
    seen.landmark = place;
    seen.useHeading = true;
    seen.useDistance = distances;
    seen.headingVariance = 0.0007;
    seen.distanceVariance = maths::square(0.05 * e.distance);
    const double beside = (e.heading - pan).rad();
    seen.heading = pan + Angle::rad(beside * stretched + off + random.gaussian(0.0, 0.01));
    seen.distance = e.distance / stretched * (1.0 + random.gaussian(0.0, 0.03));
    updateFocal({input, percepts, camera}, mode, seen, params, focal);
  }
};

TEST(Focal, IsFoundWithinTenSecondsOfLookingRound) {
  for (const double truth : {0.96, 1.0, 1.04}) {
    Looking robot;
    robot.frames(300, truth);
    EXPECT_NEAR(robot.focal.ratio, truth, 0.006);
    EXPECT_LT(std::sqrt(robot.focal.variance), 0.008);
  }
}

TEST(Focal, BearingsAloneTellIt) {
  Looking robot;
  robot.distances = false;
  robot.frames(600, 1.04);
  EXPECT_NEAR(robot.focal.ratio, 1.04, 0.015);
}

TEST(Focal, IsNotTakenForATurnOfTheBody) {
  Looking robot;
  robot.frames(300, 1.0, 0.02);
  EXPECT_NEAR(robot.focal.ratio, 1.0, 0.01);
}

TEST(Focal, AModeOfUnknownHeadingSaysNothingOfIt) {
  Looking robot;
  robot.mode.covariance[8] = 0.1;
  robot.frames(60, 1.04);
  EXPECT_EQ(robot.focal.ratio, 1.0);
}

TEST(Focal, IsNoFartherFromOneThanLensesAre) {
  Looking robot;
  robot.params.gate = 100.0;
  robot.frames(900, 1.3);
  EXPECT_LE(robot.focal.ratio, 1.0 + robot.params.max);
}

TEST(Focal, StaysWhereItIsNotEstimated) {
  Looking robot;
  robot.params.use = false;
  robot.frames(60, 1.04);
  EXPECT_EQ(robot.focal.ratio, 1.0);
}

}  // namespace
}  // namespace kelpie::gps
