// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/agent/JointTrack.h"
#include "robot/agent/OdometryTrack.h"

namespace kelpie::agent {
namespace {

constexpr std::int64_t kTickUs = 8000;

// Pan turns by 1 deg a tick; tick n is at n * 8 ms.
JointTrack panning(int ticks) {
  JointTrack track;
  for (int n = 0; n < ticks; ++n) {
    SensorFrame sensors;
    sensors.joints[Joint::headPan] = Angle::deg(n);
    track.add({n * kTickUs}, sensors);
  }
  return track;
}

TEST(JointTrack, BetweenTicksAnglesAreInterpolated) {
  EXPECT_NEAR(panning(12).at({9 * kTickUs + 2000}).joints[Joint::headPan].deg(), 9.25, 1e-9);
}

TEST(JointTrack, BeyondTheNewestTickAnglesGoOnForAtMostTwentyMilliseconds) {
  const JointTrack track = panning(12);
  EXPECT_NEAR(track.at({13 * kTickUs}).joints[Joint::headPan].deg(), 13.0, 1e-9);
  EXPECT_NEAR(track.at({40 * kTickUs}).joints[Joint::headPan].deg(), 13.5, 1e-9);
}

TEST(JointTrack, OlderThanTheMemoryGivesTheOldestTick) {
  EXPECT_NEAR(panning(40).at({0}).joints[Joint::headPan].deg(), 24.0, 1e-9);
}

TEST(JointTrack, RateIsInRadiansPerSecond) {
  EXPECT_NEAR(panning(12).headRate({5 * kTickUs}).headPan, Angle::deg(1.0).rad() / 0.008, 1e-9);
}

TEST(JointTrack, EmptyAndSingleTickAreAnswered) {
  EXPECT_EQ(JointTrack().headRate({0}).headPan, 0.0);
  EXPECT_NEAR(panning(1).at({99}).joints[Joint::headPan].deg(), 0.0, 1e-12);
}

TEST(OdometryTrack, FramesShareTheWayWithoutLossOrRepeat) {
  OdometryTrack track;
  double walked = 0.0;
  std::int64_t image = 16667;
  for (std::int64_t message = 1; message <= 100; ++message) {
    track.add({message * 32000}, {1.0, -0.5, Angle::deg(2.0)});
    while (image <= message * 32000 + 16000) {
      walked += track.until({image}).forward;
      image += 33333;
    }
  }
  EXPECT_NEAR(walked, static_cast<double>(image - 33333) / 32000.0, 1e-6);
}

TEST(OdometryTrack, NothingIsWalkedTwiceAtTheSameTime) {
  OdometryTrack track;
  track.add({32000}, {1.0, 0.0, Angle()});
  track.until({20000});
  EXPECT_EQ(track.until({20000}).forward, 0.0);
}

}  // namespace
}  // namespace kelpie::agent
