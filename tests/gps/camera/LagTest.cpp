// SPDX-License-Identifier: Apache-2.0
// The lag of the images: found from a landmark that is seen twice while the head pans.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/camera/Lag.h"
#include "robot/core/Random.h"

namespace kelpie::gps {
namespace {

// A beacon that is always in sight of a head that pans to and fro once in two seconds.
struct Panning {
  LagParams params;
  ImageLag lag = startingLag({});
  LagReferences references{};
  FrameInput input;
  Measurement beacon;
  Angle where = Angle::rad(0.3);
  Random random{7};

  Panning() {
    beacon.useHeading = true;
    beacon.distance = 200.0;
    beacon.headingVariance = 0.0007;
  }
  // Images so late, of a robot that turns by so much a frame and by `told` for its odometry.
  void frames(int count, double late, double fastest = 3.8, Angle turn = {}, Angle told = {}) {
    for (int i = 0; i < count; ++i) {
      input.headRate.headPan = fastest * std::cos(i * maths::kPi / 30.0);
      input.imageLag = lag;
      where = where - turn;
      const double beside = panRate(input) * (late - lag.seconds);
      beacon.heading = where + Angle::rad(beside + random.gaussian(0.0, 0.01));
      moveLagReferences({0.0, 0.0, told, {}}, kFrameSeconds, references);
      updateLag({input, 0.0, 0.005}, beacon, params, references, lag);
    }
  }
};

TEST(Lag, IsFoundWithinTwoSecondsOfPanning) {
  Panning head;
  head.frames(60, 0.033);
  EXPECT_NEAR(head.lag.seconds, 0.033, 0.006);
  EXPECT_LT(std::sqrt(head.lag.variance), 0.01);
}

TEST(Lag, OfFourFramesIsFoundAsWell) {
  Panning head;
  head.frames(60, 0.12);
  EXPECT_NEAR(head.lag.seconds, 0.12, 0.012);
}

TEST(Lag, IsNegativeWhereJointsAreOlderThanImages) {
  Panning head;
  head.frames(60, -0.05);
  EXPECT_NEAR(head.lag.seconds, -0.05, 0.008);
}

TEST(Lag, IsNotTakenForATurnOfTheBody) {
  Panning head;
  head.frames(60, 0.0, 3.8, Angle::deg(1.0), Angle::deg(1.0));
  EXPECT_NEAR(head.lag.seconds, 0.0, 0.006);
}

TEST(Lag, IsNotTakenForATurnThatTheOdometryDoesNotTell) {
  Panning head;
  head.frames(120, 0.0, 3.8, Angle::deg(0.5), {});
  EXPECT_NEAR(head.lag.seconds, 0.0, 0.01);
}

TEST(Lag, AHeadAtRestSaysNothingOfIt) {
  Panning head;
  head.frames(60, 0.033, 0.1);
  EXPECT_EQ(head.lag.seconds, 0.0);
}

TEST(Lag, IsNeverBeyondItsBounds) {
  Panning head;
  head.frames(200, -0.2);
  EXPECT_GE(head.lag.seconds, head.params.min);
  head.frames(400, 0.3);
  EXPECT_LE(head.lag.seconds, head.params.max);
}

}  // namespace
}  // namespace kelpie::gps
