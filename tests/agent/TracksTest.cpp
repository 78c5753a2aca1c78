// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/agent/joints/JointTrack.h"
#include "robot/agent/joints/OdometryTrack.h"
#include "robot/core/Random.h"

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

TEST(JointTrack, TheStanceIsThatOfTheExposureToo) {
  JointTrack track;
  track.add({0}, {}, {10.0, Angle::deg(6), Angle::deg(-1)});
  track.add({kTickUs}, {}, {11.0, Angle::deg(8), Angle::deg(1)});
  const Stance stance = track.stance({kTickUs / 4});
  EXPECT_NEAR(stance.shoulderHeight, 10.25, 1e-9);
  EXPECT_NEAR(stance.bodyTilt.deg(), 6.5, 1e-9);
  EXPECT_NEAR(stance.bodyRoll.deg(), -0.5, 1e-9);
}

TEST(JointTrack, BeyondTheNewestTickAnglesGoOnForAtMostATenthOfASecond) {
  const JointTrack track = panning(12);
  EXPECT_NEAR(track.at({13 * kTickUs}).joints[Joint::headPan].deg(), 13.0, 1e-9);
  EXPECT_NEAR(track.at({21 * kTickUs}).joints[Joint::headPan].deg(), 21.0, 1e-9);
  EXPECT_NEAR(track.at({40 * kTickUs}).joints[Joint::headPan].deg(), 23.5, 1e-9);
}

TEST(JointTrack, OlderThanTheMemoryGivesTheOldestTick) {
  EXPECT_NEAR(panning(40).at({0}).joints[Joint::headPan].deg(), 8.0, 1e-9);
}

TEST(JointTrack, RateIsInRadiansPerSecond) {
  EXPECT_NEAR(panning(12).headRate({5 * kTickUs}).headPan, Angle::deg(1.0).rad() / 0.008, 1e-9);
}

// Encoders' noise of 0.1 deg, sd. Over one tick of 8 ms it is 0.1 * sqrt(2) / 0.008 = 17.7 deg/s,
// 0.6 deg an image; over three ticks a third of that, 5.9 deg/s.
TEST(JointTrack, RateOverThreeTicksHasAThirdOfTheNoiseOfOne) {
  Random random(31);
  double sum = 0.0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    JointTrack track;
    for (int n = 0; n < 12; ++n) {
      SensorFrame sensors;
      sensors.joints[Joint::headPan] = Angle::deg(n + random.gaussian(0.0, 0.1));
      track.add({n * kTickUs}, sensors);
    }
    const double rate = track.headRate({5 * kTickUs + 4000}).headPan;
    sum += maths::square(Angle::rad(rate).deg() - 125.0);  // 1 deg in 8 ms
  }
  EXPECT_NEAR(std::sqrt(sum / kTrials), 5.9, 0.5);
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
    track.add({message * 32000}, {1.0, -0.5, Angle::deg(2.0), {}});
    while (image <= message * 32000 + 16000) {
      walked += track.until({image}).forward;
      image += 33333;
    }
  }
  EXPECT_NEAR(walked, static_cast<double>(image - 33333) / 32000.0, 1e-6);
}

TEST(OdometryTrack, NothingIsWalkedTwiceAtTheSameTime) {
  OdometryTrack track;
  track.add({32000}, {1.0, 0.0, Angle(), {}});
  track.until({20000});
  EXPECT_EQ(track.until({20000}).forward, 0.0);
}

TEST(OdometryTrack, AnImageOfThreeMessagesAgoGetsTheWayUntilThen) {
  OdometryTrack track;
  for (std::int64_t message = 1; message <= 6; ++message)
    track.add({message * 32000}, {static_cast<double>(message), 0.0, Angle(), {}});
  EXPECT_NEAR(track.until({3 * 32000 + 16000}).forward, 1.0 + 2.0 + 3.0 + 2.0, 1e-12);
  EXPECT_NEAR(track.until({6 * 32000}).forward, 2.0 + 5.0 + 6.0, 1e-12);
}

TEST(OdometryTrack, AnImageOfSevenMessagesAgoGetsTheWayUntilThen) {
  OdometryTrack track;
  for (std::int64_t message = 1; message <= 9; ++message)
    track.add({message * 32000}, {static_cast<double>(message), 0.0, Angle(), {}});
  EXPECT_NEAR(track.until({2 * 32000}).forward, 1.0 + 2.0, 1e-12);
}

TEST(OdometryTrack, BeyondTheNewestMessageTheWayGoesOnForAtMostThree) {
  OdometryTrack track;
  for (std::int64_t message = 1; message <= 4; ++message)
    track.add({message * 32000}, {2.0, 0.0, Angle(), {}});
  EXPECT_NEAR(track.until({6 * 32000}).forward, 12.0, 1e-12);
  EXPECT_NEAR(track.until({20 * 32000}).forward, 2.0, 1e-12);
}

}  // namespace
}  // namespace kelpie::agent
