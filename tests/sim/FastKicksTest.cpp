// SPDX-License-Identifier: Apache-2.0
// Kicks of the kinematic world against what the physical one measured of them.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/learn/motion/BallInHold.h"
#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::sim {
namespace {

constexpr int kKicks = 24;
constexpr int kRolls = 250;  // messages, 8 s
constexpr Point2<Field> kMiddle{180.0, 200.0};

struct Way {
  double distance = 0.0;  // cm
  double left = 0.0;      // deg, of where the robot looked as the kick began
};

// A ball ahead and to the left of a robot that stands, or that holds it before.
Way kicked(WalkingBody& body, MotionKind kind, double ahead, double left, bool held) {
  Command command = held ? learn::holdingCommand() : Command{};
  (void)body.world().carry(0, {kMiddle, Angle::deg(90.0)});
  for (int i = 0; i < 20; ++i) body.step(command);
  const Pose2 start = body.pose();
  const Point2<Field> from = fieldFromRobot(start, {-left, ahead});
  body.world().bodies().putBall({from, {}});
  for (int i = 0; held && i < 20; ++i) body.step(command);
  command.motion = kind;
  body.step(command);
  command = {};
  for (int i = 0; i < kRolls; ++i) body.step(command);
  const Point2<Field> way = body.world().bodies().ball().position - from;
  const double looked = start.heading.rad();
  const double toLeft = Angle::rad(std::atan2(way.y, way.x) - looked).deg();
  return {way.norm(), std::remainder(toLeft, 360.0)};
}

Way meanOf(MotionKind kind, double ahead, double left, bool held) {
  WalkingBody body(3);
  Way sum;
  for (int i = 0; i < kKicks; ++i) {
    const Way one = kicked(body, kind, ahead, left, held);
    sum.distance += one.distance / kKicks;
    sum.left += one.left / kKicks;
  }
  return sum;
}

TEST(FastKick, OfAFreeBallFromItsBestPlaceGoesAsItsFileSaysToo) {
  for (const MotionKind kind : {MotionKind::kickForward, MotionKind::headSwipeLeft,
                                MotionKind::headSwipeRight, MotionKind::upennLeft}) {
    const actuator::KickEffect& kick = actuator::standardMotions()[kind].kick;
    const Way way = meanOf(kind, kick.ahead, kick.left, false);
    EXPECT_NEAR(way.distance, kick.distance, 0.15 * kick.distance) << static_cast<int>(kind);
    EXPECT_NEAR(way.left, kick.direction.deg(), 6.0) << static_cast<int>(kind);
  }
}

// Rows of pycode/data/kick_map.py for a robot that stands, measured by `kelpie calibrate kicks`.
TEST(FastKick, OfAFreeBallAwayFromItsBestPlaceGoesAsThePhysicalOneDoes) {
  struct Measured {
    MotionKind kind;
    double ahead, left;
    double distance, direction;
  };
  const std::array<Measured, 4> all{{{MotionKind::upennLeft, 16.0, 0.0, 172.0, 59.0},
                                     {MotionKind::upennRight, 16.0, 0.0, 172.0, -59.0},
                                     {MotionKind::headSwipeLeft, 14.0, -6.0, 144.0, 12.0},
                                     {MotionKind::kickForward, 16.0, 2.0, 118.0, 20.0}}};
  for (const Measured& is : all) {
    const Way way = meanOf(is.kind, is.ahead, is.left, false);
    EXPECT_NEAR(way.distance, is.distance, 0.2 * is.distance) << static_cast<int>(is.kind);
    EXPECT_NEAR(way.left, is.direction, 6.0) << static_cast<int>(is.kind);
  }
}

// The walk has ended when the kick begins; from standing it would go 224 cm, from a walk 171.
TEST(FastKick, OfAWalkerIsAWalkersKick) {
  double mean = 0.0;
  WalkingBody body(3);
  for (int i = 0; i < kKicks; ++i) {
    (void)body.world().carry(0, {kMiddle, Angle::deg(90.0)});
    Command command;
    command.walk.forward = 10.0;
    for (int k = 0; k < 30; ++k) body.step(command);
    command = {};
    command.motion = MotionKind::upennLeft;
    body.world().bodies().putBall({fieldFromRobot(body.pose(), {4.0, 15.0}), {}});
    const Point2<Field> from = body.world().bodies().ball().position;
    for (int k = 0; k < 8; ++k) body.step(command);
    for (int k = 0; k < kRolls; ++k) body.step({});
    mean += distance(body.world().bodies().ball().position, from) / kKicks;
  }
  EXPECT_NEAR(mean, 171.0, 25.0);
}

TEST(FastKick, OfABallOutOfItsReachLeavesItThere) {
  EXPECT_NEAR(meanOf(MotionKind::upennLeft, 20.5, -4.0, false).distance, 0.0, 0.1);
  EXPECT_NEAR(meanOf(MotionKind::kickForward, 14.0, 10.0, false).distance, 0.0, 0.1);
}

// None of its parts touches such a ball.
TEST(FastKick, WhoCarriesTheBallIsReportedToTouchIt) {
  WalkingBody body(3);
  Command command = learn::holdingCommand();
  command.walk.forward = 10.0;
  (void)body.world().carry(0, {kMiddle, Angle::deg(90.0)});
  for (int i = 0; i < 20; ++i) body.step({});
  Bodies& bodies = body.world().bodies();
  EXPECT_FALSE(bodies.ballToucher());
  bodies.putBall({fieldFromRobot(body.pose(), {0.0, 8.0}), {}});
  for (int i = 0; i < 30; ++i) body.step(command);
  EXPECT_EQ(bodies.ballToucher(), std::optional<std::size_t>(0));
}

TEST(FastKick, OfAHeldBallGoesAsThePhysicalOneDoes) {
  struct Measured {
    MotionKind kind;
    double distance;
    double left;
  };
  // Rows HELD of pycode/data/kick_map.py, measured by `kelpie calibrate kicks`.
  const std::array<Measured, 4> all{{{MotionKind::hardForward, 247.0, 0.0},
                                     {MotionKind::wedge, 124.0, 1.0},
                                     {MotionKind::headSwipeLeft, 128.0, 73.0},
                                     {MotionKind::upennRight, 103.0, -76.0}}};
  for (const Measured& is : all) {
    const Way way = meanOf(is.kind, 8.0, 0.0, true);
    EXPECT_NEAR(way.distance, is.distance, 0.2 * is.distance) << static_cast<int>(is.kind);
    EXPECT_NEAR(way.left, is.left, 6.0) << static_cast<int>(is.kind);
  }
}

}  // namespace
}  // namespace kelpie::sim
