// SPDX-License-Identifier: Apache-2.0
// The lag of the images: found from bearings of landmarks while the head pans both ways.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/camera/Lag.h"
#include "gps/pose/PoseUpdate.h"
#include "robot/core/Random.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

struct Panning {
  LagParams params;
  ImageLag lag = startingLag({});
  PoseMode mode;
  FrameInput input;
  Measurement beacon;

  Panning() {
    mode.pose = kPose;
    mode.covariance = {25, 0, 0, 0, 25, 0, 0, 0, 0.0003};
    beacon.landmark = {-20.0, 300.0};
    beacon.useHeading = true;
    beacon.headingVariance = 0.0007;
  }
  // Frames of a head that pans to and fro, whose images are so late, beside a pose turned by `off`.
  void frames(int count, double late, double off, double rate = 2.5) {
    Random random(7);
    for (int i = 0; i < count; ++i) {
      input.headRate.headPan = i % 20 < 10 ? rate : -rate;
      input.imageLag = lag;
      const double beside = panRate(input) * (late - lag.seconds);
      beacon.heading = expected(kPose, beacon.landmark).heading +
                       Angle::rad(beside + off + random.gaussian(0.0, 0.01));
      updateLag(input, mode, beacon, params, lag);
    }
  }
};

TEST(Lag, IsFoundWithinASecondOfPanning) {
  Panning head;
  head.frames(30, 0.033, 0.0);
  EXPECT_NEAR(head.lag.seconds, 0.033, 0.004);
  EXPECT_LT(std::sqrt(head.lag.variance), 0.004);
}

TEST(Lag, IsNotTakenForATurnOfTheBody) {
  Panning head;
  head.frames(60, 0.0, 0.05);
  EXPECT_LT(head.lag.seconds, 0.006);
}

TEST(Lag, AHeadAtRestSaysNothingOfIt) {
  Panning head;
  head.frames(60, 0.033, 0.0, 0.1);
  EXPECT_EQ(head.lag.seconds, 0.0);
}

TEST(Lag, IsNeverNegativeNorLongerThanItCanBe) {
  Panning head;
  head.frames(60, -0.02, 0.0);
  EXPECT_EQ(head.lag.seconds, 0.0);
  head.frames(200, 0.09, 0.0, 1.0);
  EXPECT_LE(head.lag.seconds, head.params.max);
}

}  // namespace
}  // namespace kelpie::gps
