// SPDX-License-Identifier: Apache-2.0
// Balls out, goals, kicks: what makes a ball be elsewhere at once.
#include <gtest/gtest.h>

#include "gps/ball/BallMotion.h"
#include "gps/ball/DropIn.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

// Looks at a ball on the field without any noise, or looks away.
struct Watcher {
  Watcher(double x, double y) : robot({x, y, maths::kPi / 2}) {
    robot.params.initialPose = {true, {{x, y}, Angle::deg(90)}, 1.0, Angle::deg(0.5)};
  }

  WorldModel step(bool seen) {
    const double dx = ball.x - robot.truth.x;
    const double dy = ball.y - robot.truth.y;
    BallPercept& p = robot.percepts.ball;
    p = BallPercept{};
    p.present = seen;
    p.distance = std::hypot(dx, dy);
    p.heading = Angle::rad(std::atan2(dy, dx) - robot.truth.heading);
    p.distanceVariance = maths::square(0.02 * p.distance);
    p.headingVariance = 1e-4;
    p.centre = {104, 80};
    p.radius = 5;
    return robot.step();
  }

  sim::LocalisingRobot robot;
  Point2<Field> ball;
};

TEST(DropIn, PointsAreThoseOfTheRules) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  const auto expect = [&](double x, double y, double atX, double atY) {
    const Point2<Field> point = body::throwInPlace(field, {x, y});
    EXPECT_NEAR(point.x, atX, 1e-9);
    EXPECT_NEAR(point.y, atY, 1e-9);
  };
  expect(-10, 270, 40, 270);
  expect(371, 30, 320, 100);
  expect(100, 548, 40, 440);
  expect(300, -9, 320, 100);
}

TEST(DropIn, TheWholeBallMustBeBeyondTheLineAndAGoalIsNotOut) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  EXPECT_LT(beyondLines(field, {-4.0, 200}), 0.0);
  EXPECT_NEAR(beyondLines(field, {-6.2, 200}), 2.0, 1e-9);
  EXPECT_NEAR(beyondLines(field, {90, 550.2}), 6.0, 1e-9);
  EXPECT_LT(beyondLines(field, {180, 550}), 0.0);
}

TEST(DropIn, ABallThatRolledOutUnseenIsPutIn) {
  Watcher watcher(200, 150);
  watcher.ball = {280, 270};
  double speed = 130.0;
  WorldModel world;
  for (int i = 0; i < 15; ++i) {
    speed -= (6.0 + 0.8 * speed) * kFrameSeconds;
    watcher.ball.x += speed * kFrameSeconds;
    world = watcher.step(true);
  }
  EXPECT_LT(world.ball.position.x, 345.0);
  EXPECT_GT(world.ball.stoppingPoint.x, 380.0);
  for (int i = 0; i < 45; ++i) world = watcher.step(false);
  ASSERT_TRUE(world.ball.present);
  EXPECT_NEAR(world.ball.position.x, 320.0, 1.0);
  EXPECT_NEAR(world.ball.position.y, 270.0, 5.0);
  EXPECT_LT(world.ball.velocity.norm(), 0.1);
}

TEST(DropIn, ALostRobotDoesNotKnowWhatIsOut) {
  Watcher watcher(200, 150);
  watcher.ball = {330, 270};
  for (int i = 0; i < 10; ++i) watcher.step(true);
  GpsState& state = watcher.robot.state;
  for (BallHypothesis* ball :
       {&state.ball.track.still, &state.ball.track.rolling, &state.ball.track.both})
    ball->mean[0] += 60.0;  // 390 cm across the field, 30 cm beyond the line
  state.ball.track.secondsSinceSeen = 10.0;
  state.pose.lost = true;
  EXPECT_GT(watcher.step(false).ball.position.x, 360.0);
  state.pose.lost = false;
  EXPECT_LT(watcher.step(false).ball.position.x, 330.0);
}

TEST(DropIn, ABallSeenOutsideIsWhereItIsSeen) {
  Watcher watcher(300, 250);
  watcher.ball = {375, 270};
  WorldModel world;
  for (int i = 0; i < 30; ++i) world = watcher.step(true);
  EXPECT_NEAR(world.ball.position.x, 375.0, 2.0);
}

TEST(Goal, PutsAnUnseenBallInTheCentre) {
  Watcher watcher(180, 400);
  watcher.ball = {180, 500};
  for (int i = 0; i < 10; ++i) watcher.step(true);
  watcher.robot.input.game.ownScore = 1;
  const WorldModel world = watcher.step(false);
  EXPECT_NEAR(world.ball.position.x, 180.0, 1.0);
  EXPECT_NEAR(world.ball.position.y, 270.0, 1.0);
}

class Kick : public testing::TestWithParam<double> {};

TEST_P(Kick, IsAJumpTakenWithinTwoSightings) {
  Watcher watcher(180, 200);
  watcher.ball = {180, 260};
  WorldModel world;
  for (int i = 0; i < 60; ++i) world = watcher.step(true);
  ASSERT_LT(world.ball.velocity.norm(), 0.5);
  for (int i = 0; i < 2; ++i) {
    watcher.ball.y += GetParam() * kFrameSeconds;
    world = watcher.step(true);
  }
  EXPECT_NEAR(world.ball.position.y, watcher.ball.y, 3.0);
  for (int i = 0; i < 3; ++i) {
    watcher.ball.y += GetParam() * kFrameSeconds;
    world = watcher.step(true);
  }
  EXPECT_NEAR(world.ball.velocity.y, GetParam(), 0.25 * GetParam());
}

INSTANTIATE_TEST_SUITE_P(Ball, Kick, testing::Values(120.0, 160.0, 250.0));

// Seen for two seconds while it rolls at this speed, then once this far beside its way, then not
// again for a second while the head looks elsewhere.
WorldModel seenOnceOffLine(double speed, double lateral, Watcher& watcher) {
  watcher.ball = {120, 330};
  for (int i = 0; i < 60; ++i) {
    watcher.ball.x += speed * kFrameSeconds;
    watcher.step(true);
  }
  watcher.ball.y += lateral;
  WorldModel world = watcher.step(true);
  watcher.ball.y -= lateral;
  EXPECT_NEAR(world.ball.velocity.y, 0.0, 5.0);
  watcher.robot.input.sensors.joints[Joint::headPan] = Angle::deg(90);
  for (int i = 0; i < 30; ++i) world = watcher.step(false);
  return world;
}

TEST(Jump, OfALyingBallSeenOnceAndThenNothingIsNotBelieved) {
  for (const double lateral : {10.0, 12.0, 20.0, -15.0}) {
    Watcher watcher(180, 200);
    const WorldModel world = seenOnceOffLine(0.0, lateral, watcher);
    // At 143 cm one sighting is off by 3 cm: it moves what 60 said by a fifth of itself at most.
    EXPECT_NEAR(world.ball.position.x, 120.0, 2.0) << lateral;
    EXPECT_NEAR(world.ball.position.y, 330.0, 2.0) << lateral;
  }
}

TEST(Jump, OfARollingBallSeenOnceAndThenNothingIsNotBelieved) {
  for (const double lateral : {10.0, 20.0, -15.0}) {
    Watcher watcher(180, 200);
    const WorldModel world = seenOnceOffLine(30.0, lateral, watcher);
    EXPECT_NEAR(world.ball.position.y, 330.0, 4.0) << lateral;
  }
}

TEST(Jump, ThatTheNextSightingDoesNotConfirmIsForgotten) {
  Watcher watcher(180, 200);
  watcher.ball = {180, 260};
  for (int i = 0; i < 60; ++i) watcher.step(true);
  watcher.ball.x += 10.0;
  watcher.step(true);
  watcher.ball.x -= 10.0;
  EXPECT_NEAR(watcher.step(true).ball.position.x, 180.0, 0.5);
  watcher.ball.x += 12.0;  // nor does one like it later
  const WorldModel world = watcher.step(true);
  EXPECT_NEAR(world.ball.position.x, 180.0, 0.5);
  EXPECT_LT(world.ball.velocity.norm(), 1.0);
}

TEST(Jump, AfterAnOwnKickIsBelievedAtOnce) {
  for (const bool kicks : {false, true}) {
    Watcher watcher(180, 200);
    watcher.ball = {180, 215};
    for (int i = 0; i < 60; ++i) watcher.step(true);
    if (kicks) watcher.robot.input.motion.running = MotionKind::kickForward;
    for (int i = 0; i < 3; ++i) watcher.step(false);
    watcher.robot.input.motion.running = MotionKind::none;
    watcher.step(false);
    watcher.ball.y += 40.0;
    EXPECT_NEAR(watcher.step(true).ball.position.y, kicks ? 255.0 : 215.0, 2.0);
  }
}

TEST(Bounce, IsAJumpTakenWithinTwoSightings) {
  Watcher watcher(180, 150);
  watcher.ball = {120, 230};
  double speed = 100.0;
  WorldModel world;
  for (int i = 0; i < 20; ++i) {
    watcher.ball.x += speed * kFrameSeconds;
    world = watcher.step(true);
  }
  speed = -60.0;
  for (int i = 0; i < 3; ++i) {
    watcher.ball.x += speed * kFrameSeconds;
    world = watcher.step(true);
  }
  EXPECT_NEAR(world.ball.position.x, watcher.ball.x, 3.0);
  EXPECT_LT(world.ball.velocity.x, 0.0);
}

TEST(OwnMotion, LeavesAnUnseenLyingBallAtItsPlaceOnTheField) {
  Watcher watcher(180, 200);
  watcher.ball = {230, 280};
  WorldModel world;
  for (int i = 0; i < 30; ++i) world = watcher.step(true);
  const Point2<Field> before = world.ball.position;
  for (int i = 0; i < 60; ++i) {
    watcher.robot.walk(0.5, 0.3, 0.06);
    world = watcher.step(false);
    ASSERT_NEAR(world.ball.position.x, before.x, 0.5) << i;
    ASSERT_NEAR(world.ball.position.y, before.y, 0.5) << i;
  }
}

TEST(Rolling, DistanceIsThatOfSmallSteps) {
  for (const double speed : {5.0, 40.0, 200.0}) {
    double left = speed;
    double way = 0.0;
    while (left > 0.0) {
      way += left * 1e-4;
      left -= (6.0 + 0.8 * left) * 1e-4;
    }
    EXPECT_NEAR(rollingDistance(speed, {}), way, 0.02 + 1e-4 * way);
  }
}

}  // namespace
}  // namespace kelpie::gps
