// SPDX-License-Identifier: Apache-2.0
// When a ball is held, for how long, and how far it is taken.
#include <gtest/gtest.h>

#include "robot/core/Time.h"
#include "tools/sim/bodies/HoldWatch.h"

namespace kelpie::sim {
namespace {

const Pose2 kUpField{{180.0, 100.0}, Angle::deg(90.0)};

// So many seconds of frames: a robot that goes ahead at that speed, the ball that far before it.
void watch(double seconds, double speed, Point2<Robot> ball, Pose2& robot, double& now,
           HoldWatch& watch) {
  const int frames = static_cast<int>(seconds / kFrameSeconds + 0.5);
  for (int i = 0; i < frames; ++i) {
    now += kFrameSeconds;
    robot.position.y += speed * kFrameSeconds;
    watch.see(now, robot, fieldFromRobot(robot, ball));
  }
}

struct Watched {
  HoldWatch holds;
  Pose2 robot = kUpField;
  double now = 0.0;

  void goes(double seconds, double speed, Point2<Robot> ball) {
    watch(seconds, speed, ball, robot, now, holds);
  }
};

constexpr Point2<Robot> kGrip{0.0, 8.0};
constexpr Point2<Robot> kAway{0.0, 30.0};

TEST(HoldWatch, TheHoldIsBetweenChinChestAndForelegs) {
  EXPECT_TRUE(inHold(kUpField, {180.0, 108.0}));
  EXPECT_FALSE(inHold(kUpField, {180.0, 111.5}));
  EXPECT_FALSE(inHold(kUpField, {180.0, 102.5}));
  EXPECT_TRUE(inHold(kUpField, {183.5, 108.0}));
  EXPECT_FALSE(inHold(kUpField, {184.5, 108.0}));
}

TEST(HoldWatch, ABallThatIsCarriedIsHeldForItsTimeAndItsWay) {
  Watched match;
  match.goes(1.0, 20.0, kAway);
  match.goes(2.0, 20.0, kGrip);
  EXPECT_TRUE(match.holds.now());
  match.goes(1.0, 0.0, kAway);
  ASSERT_EQ(match.holds.ended().size(), 1U);
  EXPECT_NEAR(match.holds.ended()[0].seconds(), 2.0, 0.05);
  EXPECT_NEAR(match.holds.ended()[0].moved, 40.0, 1.0);
  EXPECT_FALSE(match.holds.now());
}

TEST(HoldWatch, ABallThatOnlyPassesIsNotHeld) {
  Watched match;
  match.goes(0.15, 0.0, kGrip);
  match.goes(1.0, 0.0, kAway);
  match.holds.finish();
  EXPECT_TRUE(match.holds.ended().empty());
}

TEST(HoldWatch, ABounceOutOfTheGripAndBackIsOneHold) {
  Watched match;
  match.goes(1.0, 0.0, kGrip);
  match.goes(0.067, 0.0, {0.0, 12.0});
  match.goes(1.0, 0.0, kGrip);
  match.goes(0.2, 0.0, {0.0, 12.0});
  match.goes(1.0, 0.0, kGrip);
  match.holds.finish();
  ASSERT_EQ(match.holds.ended().size(), 2U);
  EXPECT_NEAR(match.holds.ended()[0].seconds(), 2.07, 0.05);
}

TEST(HoldWatch, ThreeSecondsAndFiftyCentimetresAreWithinTheRules) {
  const body::Rules rules;
  Hold hold;
  hold.end = 3.0;
  hold.moved = 50.0;
  EXPECT_FALSE(hold.tooLong(rules));
  EXPECT_FALSE(hold.tooFar(rules));
  hold.end = 3.01;
  hold.moved = 50.1;
  EXPECT_TRUE(hold.tooLong(rules));
  EXPECT_TRUE(hold.tooFar(rules));
}

TEST(HoldWatch, TheWayIsTheFarthestFromTheStartNotWhereItEnds) {
  Watched match;
  match.goes(1.5, 20.0, kGrip);
  match.goes(1.5, -20.0, kGrip);
  match.holds.finish();
  ASSERT_EQ(match.holds.ended().size(), 1U);
  EXPECT_NEAR(match.holds.ended()[0].moved, 30.0, 1.0);
}

TEST(HoldWatch, TurningWithTheBallIsCountedToo) {
  HoldWatch holds;
  Pose2 robot = kUpField;
  for (int i = 0; i <= 30; ++i) {
    robot.heading = Angle::deg(90.0 + 3.0 * i);
    holds.see(i * kFrameSeconds, robot, fieldFromRobot(robot, kGrip));
  }
  holds.finish();
  ASSERT_EQ(holds.ended().size(), 1U);
  EXPECT_NEAR(holds.ended()[0].turned, 0.5 * maths::kPi, 1e-6);
  EXPECT_EQ(holds.ended()[0].moved, 0.0);
}

}  // namespace
}  // namespace kelpie::sim
