// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

// A ball on the field, seen from the true pose with 3 % and 1 deg of noise.
class BallScene {
 public:
  BallScene(sim::TruePose start, double ballX, double ballY)
      : robot(start), x(ballX), y(ballY), random_(3) {
    robot.params.initialPose = {
        true, {{start.x, start.y}, Angle::rad(start.heading)}, 1.0, Angle::deg(0.5)};
    // Looks straight ahead and down: a ball 60 cm ahead is in the image, one behind is not.
    robot.input.sensors.joints[Joint::neckTilt] = Angle::deg(-10);
  }

  WorldModel step(bool seen, double noise = 1.0) {
    const double dx = x - robot.truth.x, dy = y - robot.truth.y;
    const double r = std::hypot(dx, dy);
    BallPercept& p = robot.percepts.ball;
    p = BallPercept{};
    p.present = seen;
    p.distance = r * random_.gaussian(1.0, 0.03 * noise);
    p.heading = Angle::rad(std::atan2(dy, dx) - robot.truth.heading +
                           random_.gaussian(0.0, noise * maths::kPi / 180.0));
    p.distanceVariance = maths::square(0.03 * r) + 0.2;
    p.headingVariance = maths::square(maths::kPi / 180.0);
    return robot.step();
  }

  sim::LocalisingRobot robot;
  double x;
  double y;

 private:
  Random random_;
};

double speed(const WorldModel& world) {
  return std::hypot(world.ball.velocity.x, world.ball.velocity.y);
}

struct Walk {
  double forward;
  double left;
  double turn;
};

class StillBall : public testing::TestWithParam<Walk> {};

TEST_P(StillBall, IsStillForAWalkingRobot) {
  BallScene scene({180, 200, 0.9}, 250, 300);
  double sum = 0.0;
  for (int i = 0; i < 90; ++i) {
    scene.robot.walk(GetParam().forward, GetParam().left, GetParam().turn);
    const WorldModel world = scene.step(true);
    if (i >= 60) sum += speed(world) / 30;
  }
  std::printf("still ball: %.2f cm/s\n", sum);
  EXPECT_LT(sum, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Ball, StillBall,
                         testing::Values(Walk{0, 0, 0}, Walk{1, 0, 0}, Walk{0, 0.6, 0},
                                         Walk{0, 0, 0.05}, Walk{0.8, -0.3, 0.03}));

TEST(Ball, FieldPositionFollowsFromThePose) {
  BallScene scene({100, 150, 2.0}, 60, 260);
  WorldModel world;
  for (int i = 0; i < 30; ++i) world = scene.step(true, 0.0);
  EXPECT_NEAR(world.ball.position.x, 60.0, 0.5);
  EXPECT_NEAR(world.ball.position.y, 260.0, 0.5);
}

TEST(Ball, UnseenBallStaysWhereItIsWhileTheRobotMoves) {
  BallScene scene({180, 200, 0.9}, 60, 100);
  for (int i = 0; i < 30; ++i) scene.step(true, 0.0);
  WorldModel world;
  for (int i = 0; i < 60; ++i) {
    scene.robot.walk(0.8, -0.2, -0.03);
    world = scene.step(false);
  }
  EXPECT_TRUE(world.ball.present);
  EXPECT_NEAR(world.ball.position.x, 60.0, 2.0);
  EXPECT_NEAR(world.ball.position.y, 100.0, 2.0);
  EXPECT_NEAR(world.ball.secondsSinceSeen, 2.0, 1e-9);
}

TEST(Ball, HeldBallGoesWithTheRobotWhateverVisionSees) {
  BallScene scene({180, 200, 0.9}, 250, 300);
  for (int i = 0; i < 30; ++i) scene.step(true);
  scene.robot.input.motion.feeling.ballHeld = true;
  for (int i = 0; i < 20; ++i) {
    scene.robot.walk(0.0, 0.0, 2.0);
    const WorldModel world = scene.step(true);
    EXPECT_NEAR(world.ball.relative.x, 0.0, 0.1);
    EXPECT_NEAR(world.ball.relative.y, 8.0, 0.1);
  }
}

TEST(Ball, RollingBallHasItsSpeed) {
  double rolling = 120.0;  // cm/s, slowed by 6 cm/s2 and 0.8 of itself a second
  BallScene scene({180, 100, maths::kPi / 2}, 100, 250);
  WorldModel world;
  for (int i = 0; i < 45; ++i) {
    rolling -= (6.0 + 0.8 * rolling) * kFrameSeconds;
    scene.x += rolling * kFrameSeconds;
    world = scene.step(true);
  }
  EXPECT_NEAR(world.ball.velocity.x, rolling, 12.0);
  EXPECT_NEAR(rolling, 30.0, 2.0);
  EXPECT_NEAR(world.ball.velocity.y, 0.0, 15.0);
}

TEST(Ball, SingleFalseSightingIsRefusedAndTheSecondBelieved) {
  BallScene scene({180, 200, 0.9}, 230, 280);
  for (int i = 0; i < 60; ++i) scene.step(true);
  scene.x = 60;
  const double before = scene.step(true).ball.position.x;
  EXPECT_NEAR(before, 230.0, 10.0);
  EXPECT_NEAR(scene.step(true).ball.position.x, 60.0, 20.0);
}

TEST(Ball, UnseenBallIsGivenUpAfterItsTimeWithGrowingVariance) {
  BallScene scene({180, 200, 0.9}, 60, 100);  // behind the robot
  scene.step(true);
  double variance = scene.step(true).ball.covariance[0];
  for (int i = 0; i < 149; ++i) {
    const WorldModel world = scene.step(false);
    ASSERT_TRUE(world.ball.present) << i;
    ASSERT_GT(world.ball.covariance[0], variance);
    variance = world.ball.covariance[0];
  }
  scene.step(false);
  scene.step(false);
  EXPECT_FALSE(scene.step(false).ball.present);
}

TEST(Ball, OneSightingIsNoBallNorAreTwoFarApart) {
  BallScene scene({180, 200, 0.9}, 230, 280);
  EXPECT_FALSE(scene.step(true).ball.present);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(scene.step(false).ball.present);
  EXPECT_FALSE(scene.step(true).ball.present);
  scene.x = 60;
  EXPECT_FALSE(scene.step(true).ball.present);
  EXPECT_TRUE(scene.step(true).ball.present);
}

TEST(Ball, NeverRollsThroughTheRobot) {
  BallScene scene({180, 200, maths::kPi / 2}, 180, 300);
  for (int i = 0; i < 30; ++i) {
    scene.y -= 2.5;  // 75 cm/s towards the robot
    scene.step(true);
  }
  for (int i = 0; i < 30; ++i) EXPECT_GT(scene.step(false).ball.relative.y, 5.0);
}

TEST(Ball, NearBallMissingInTheImageIsGivenUpSooner) {
  BallScene scene({180, 200, maths::kPi / 2}, 180, 260);
  for (int i = 0; i < 30; ++i) scene.step(true);
  int frames = 0;
  while (scene.step(false).ball.present) ASSERT_LT(++frames, 200);
  EXPECT_LT(frames, 60);
}

}  // namespace
}  // namespace kelpie::gps
