// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "actuator/motion/MotionData.h"
#include "tests/sim/Targets.h"
#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/referee/Referee.h"
#include "tools/sim/world/Ball.h"
#include "tools/sim/world/BallContact.h"

namespace kelpie::sim {
namespace {

TEST(Ball, RollsToAStopAtTheAnalyticDistance) {
  const BallParams params;
  Ball ball{{100, 100}, {120, 160}};  // 200 cm/s
  for (int i = 0; i < 2000; ++i) tickBall(ball, {}, {}, params);
  // dv/dt = -(k v + c): the way is v/k - c/k2 ln(1 + k v / c).
  const double k = -std::log(0.975) * 30.0;
  const double way = 200.0 / k - 6.0 / (k * k) * std::log(1.0 + k * 200.0 / 6.0);
  EXPECT_NEAR(distance(ball.position, Point2<Field>{100, 100}), way, 1e-6 * way);
  EXPECT_EQ(ball.velocity.norm(), 0.0);
}

TEST(Ball, LosesAFortiethOfItsSpeedPerFrame) {
  BallParams params;
  params.friction = 0.0;
  Ball ball{{0, 0}, {200, 0}};
  roll(ball, 1.0 / 30.0, params);
  EXPECT_NEAR(ball.velocity.x, 195.0, 1e-9);
}

TEST(Ball, BouncesOffAPost) {
  const auto field = *body::fieldDescription("2006");
  const auto obstacles = obstaclesOf(field);
  Ball ball{{140, 500}, {0, 150}};  // straight at the blue goal's left post, x = 140, y = 540
  for (int i = 0; i < 60; ++i) tickBall(ball, {}, obstacles, {});
  EXPECT_LT(ball.velocity.y, -20.0);
  EXPECT_NEAR(ball.position.x, 140.0, 0.5);
  EXPECT_LT(ball.position.y, 540.0 - 5.2 + 1e-6);
}

TEST(Ball, StaysInsideTheGoal) {
  const auto obstacles = obstaclesOf(*body::fieldDescription("2006"));
  Ball ball{{180, 530}, {60, 90}};  // too slow to come out again
  for (int i = 0; i < 400; ++i) tickBall(ball, {}, obstacles, {});
  EXPECT_GT(ball.position.x, 140.0);
  EXPECT_LT(ball.position.x, 220.0);
  EXPECT_LT(ball.position.y, 570.0);
}

TEST(Ball, PushedByTheChestItRunsAhead) {
  RobotParams params;
  const RobotModel robot(params, Pose2{{180, 200}, Angle::deg(90)}, 1);
  Ball ball{{180, 200 + kChestAhead + body::kBallRadius - 0.5}, {}};
  tickBall(ball, {&robot}, {}, {});
  EXPECT_NEAR(ball.position.y, 200 + kChestAhead + body::kBallRadius, 0.05);
  EXPECT_NEAR(ball.position.x, 180.0, 1e-6);
}

TEST(Ball, TheRobotThatPushedItIsReported) {
  const RobotModel far(RobotParams{}, Pose2{{60, 200}, Angle::deg(90)}, 1);
  const RobotModel near(RobotParams{}, Pose2{{180, 200}, Angle::deg(90)}, 2);
  Ball ball{{180, 200 + kChestAhead + body::kBallRadius - 0.5}, {0, -50}};
  EXPECT_EQ(tickBall(ball, {&far, &near}, {}, {}).strongest, std::optional<std::size_t>(1));
  ball.position = {120, 300};
  EXPECT_FALSE(tickBall(ball, {&far, &near}, {}, {}).strongest);
}

// Two robots, each pushed towards it by 6 mm a tick from anywhere, turned anyhow. Without being
// held up they come through the ball, which then leaps out behind one of them.
TEST(Ball, BetweenTwoRobotsHoldsThemUp) {
  const Point2<Field> at{180.0, 200.0};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    KinematicBodies bodies({}, *body::fieldDescription("2006"));
    std::array<Angle, 2> from;
    for (Angle& side : from) {
      side = Angle::deg(random.uniform(-180.0, 180.0));
      const Pose2 pose{at + Point2<Field>{side.cos(), side.sin()} * 40.0,
                       Angle::deg(random.uniform(-180.0, 180.0))};
      bodies.add(RobotModel(RobotParams{}, pose, seed));
    }
    bodies.putBall({at, {}});
    for (int i = 0; i < 150; ++i) {
      const Point2<Field> was = bodies.ball().position;
      for (std::size_t k = 0; k < 2; ++k) {
        const Point2<Field> way = was - bodies.place(k).pose.position;
        bodies.robot(k).push(way * (0.6 / way.norm()));
      }
      ASSERT_TRUE(bodies.tick().ok());
      ASSERT_LT(distance(bodies.ball().position, was), 3.0) << "seed " << seed << " tick " << i;
      for (std::size_t k = 0; k < 2; ++k) {
        const Point2<Robot> p = robotFromField(bodies.place(k).pose, bodies.ball().position);
        const bool inTrunk =
            std::fabs(p.x) < kTrunkHalfWidth && p.y < kChestAhead && p.y > kTrunkBack;
        ASSERT_FALSE(inTrunk) << "seed " << seed << " tick " << i;
      }
    }
  }
}

// Pushed by 4 mm a tick the other one goes on by 2, and the holder goes back as far.
TEST(Ball, HeldByOneRobotIsNotPushedOutByAnother) {
  KinematicBodies bodies({}, *body::fieldDescription("2006"));
  bodies.add(RobotModel(RobotParams{}, Pose2{{180, 200}, Angle::deg(90)}, 1));
  bodies.add(RobotModel(RobotParams{}, Pose2{{180, 230}, Angle::deg(-90)}, 2));
  JointAngles head = bodies.robot(0).target();
  head[Joint::neckTilt] = Angle::deg(-52.0);
  head[Joint::headNod] = Angle::deg(45.0);
  head[Joint::mouth] = Angle::deg(-55.0);
  bodies.command(0, targets(head));
  bodies.putBall({{180, 207}, {}});
  for (int i = 0; i < 120; ++i) {
    bodies.robot(1).push({0.0, -0.4});
    ASSERT_TRUE(bodies.tick().ok());
    if (i < 30) continue;  // it draws the ball in
    const Point2<Robot> at = robotFromField(bodies.place(0).pose, bodies.ball().position);
    ASSERT_LT(distance(at, {0.0, 7.9}), 1.5) << i;
  }
  const double holder = bodies.place(0).pose.position.y;
  EXPECT_NEAR(holder, 200.0 - 0.5 * 120 * 0.4, 10.0);
  EXPECT_GT(bodies.place(1).pose.position.y, holder + 7.9 + body::kBallRadius);
}

// U-Penn sends a ball at its best place 43 deg to the left, where the other one stands.
TEST(Ball, KickedAgainstARobotIsTouchedByThatOneLast) {
  const Angle way = Angle::deg(90.0 + 43.0);
  const Point2<Field> at{184.0, 214.0};
  const double chest = body::kBallRadius + kChestAhead - 0.2;
  KinematicBodies bodies({}, *body::fieldDescription("2006"));
  bodies.add(RobotModel(RobotParams{}, Pose2{{180, 200}, Angle::deg(90)}, 1));
  const Point2<Field> there = at + Point2<Field>{way.cos(), way.sin()} * chest;
  bodies.add(RobotModel(RobotParams{}, Pose2{there, way + Angle::deg(180.0)}, 2));
  JointAngles kick = bodies.robot(0).target();
  const auto& angles = actuator::standardMotions()[MotionKind::upennLeft].frames.back().angles;
  for (std::size_t j = 0; j < actuator::kLegJoints; ++j)
    kick.angle[index(Joint::leftFrontRotator) + j] = angles[j];
  bodies.putBall({{20, 20}, {}});
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(bodies.tick().ok());  // it stands before it kicks
  bodies.putBall({at, {}});
  bodies.command(0, targets(body::withinLimits(kick)));
  std::vector<std::size_t> touchers;
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(bodies.tick().ok());
    if (bodies.ballToucher()) touchers.push_back(*bodies.ballToucher());
    if (touchers.size() == 2) break;
  }
  EXPECT_EQ(touchers, (std::vector<std::size_t>{0, 1}));
}

TEST(Ball, NeverRunsFasterThanTheLimit) {
  Ball ball{{180, 200}, {900, 0}};
  tickBall(ball, {}, {}, {});
  EXPECT_LE(ball.velocity.norm(), 300.0 + 1e-9);
}

TEST(Referee, GoalNeedsTheWholeBallBehindTheLineBetweenThePosts) {
  const auto field = *body::fieldDescription("2006");
  EXPECT_EQ(goalFor(field, {180, 544.3}), TeamColour::red);
  EXPECT_EQ(goalFor(field, {180, -4.3}), TeamColour::blue);
  EXPECT_FALSE(goalFor(field, {180, 544.1}));
  EXPECT_FALSE(goalFor(field, {180, -4.1}));
  EXPECT_FALSE(goalFor(field, {221, 546}));
  EXPECT_FALSE(goalFor(field, {100, -6}));
  EXPECT_TRUE(ballOut(field, {100, -6}));
  EXPECT_TRUE(ballOut(field, {364.3, 300}));
  EXPECT_FALSE(ballOut(field, {364.1, 300}));
  EXPECT_FALSE(ballOut(field, {180, 550}));
}

TEST(Referee, BallOutComesBackToTheThrowInPlace) {
  const auto field = *body::fieldDescription("2006");
  Referee referee({}, field);
  Ball ball{{370, 530}, {50, 0}};
  referee.tick({8000}, ball);
  EXPECT_EQ(ball.position.x, 320.0);
  EXPECT_EQ(ball.position.y, 440.0);
  EXPECT_EQ(ball.velocity.norm(), 0.0);
  EXPECT_EQ(referee.score().outs, 1);
  EXPECT_EQ(referee.takeEvents().size(), 2U);  // start, out
}

TEST(Referee, MatchEndsAtTheGoalLimitAndAtTheTimeLimit) {
  const auto field = *body::fieldDescription("2006");
  RefereeParams params;
  params.goals = 2;
  params.seconds = 10;
  Referee referee(params, field);
  Ball ball{{180, 550}, {}};
  referee.tick({8000}, ball);
  EXPECT_FALSE(referee.finished());
  EXPECT_EQ(ball.position.y, 270.0);
  ball.position.y = 550;
  referee.tick({16000}, ball);
  EXPECT_TRUE(referee.finished());
  ASSERT_EQ(referee.score().goals.size(), 2U);
  EXPECT_DOUBLE_EQ(referee.score().goals[0].time, 0.008);
  EXPECT_DOUBLE_EQ(referee.score().goals[1].time, 0.016);
  Referee timed(params, field);
  Ball still{{180, 270}, {}};
  timed.tick({10000000}, still);
  EXPECT_TRUE(timed.finished());
}

}  // namespace
}  // namespace kelpie::sim
