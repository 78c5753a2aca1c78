// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "gps/Refusal.h"
#include "gps/players/Information.h"
#include "gps/players/Team.h"
#include "gps/players/TeamBall.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A robot that knows its place, in the middle of its half, looking up-field.
sim::LocalisingRobot robotAt(double x, double y) {
  sim::LocalisingRobot robot({x, y, maths::kPi / 2});
  robot.params.initialPose = {true, {{x, y}, Angle::deg(90)}, 3.0, Angle::deg(1)};
  return robot;
}

RobotPercept opponentAt(const sim::LocalisingRobot& robot, double x, double y) {
  const double dx = x - robot.truth.x;
  const double dy = y - robot.truth.y;
  RobotPercept p;
  p.team = TeamColour::blue;
  p.distance = std::hypot(dx, dy);
  p.heading = Angle::rad(std::atan2(dy, dx) - robot.truth.heading);
  p.distanceVariance = maths::square(0.15 * p.distance);
  p.headingVariance = maths::square(0.035);
  return p;
}

TeamMessage messageFrom(std::uint8_t player, std::uint16_t number) {
  TeamMessage m;
  m.player = player;
  m.number = number;
  m.pose = {{100, 300}, Angle::deg(20)};
  m.covariance = {25, 0, 0, 0, 25, 0, 0, 0, 0.01};
  m.ball = {true, {200, 250}, {0, 0}, {20, 0, 0, 20}, 0.0};
  m.opponents.push_back({{150, 400}, {100, 0, 0, 100}});
  return m;
}

TEST(TeamBall, FusionIsTheProductOfTheGaussians) {
  const Place a{Vector2(10, 20), (Matrix2() << 9, 2, 2, 4).finished()};
  const Place b{Vector2(13, 18), (Matrix2() << 5, -1, -1, 16).finished()};
  const Place both = productOf(a, b);
  const Matrix2 information = a.covariance.inverse() + b.covariance.inverse();
  const Vector2 mean =
      information.inverse() * (a.covariance.inverse() * a.mean + b.covariance.inverse() * b.mean);
  EXPECT_TRUE(both.covariance.isApprox(information.inverse(), 1e-12));
  EXPECT_TRUE(both.mean.isApprox(mean, 1e-12));
  EXPECT_LT(both.covariance.determinant(), a.covariance.determinant());
}

TEST(Information, AddsUpToTheSameAsTheCovarianceForm) {
  const Place a{Vector2(100, 220), (Matrix2() << 90, 20, 20, 40).finished()};
  const Place b{Vector2(130, 180), (Matrix2() << 50, -10, -10, 160).finished()};
  Information sum = informationOf(a);
  add(informationOf(b), sum);
  EXPECT_TRUE(placeOf(sum).mean.isApprox(productOf(a, b).mean, 1e-9));
  EXPECT_TRUE(placeOf(sum).covariance.isApprox(productOf(a, b).covariance, 1e-9));
}

TEST(TeamBall, OneWrongWitnessOfThreeIsOutvotedHoweverSureItIs) {
  Witnesses list;
  list.push_back({{Vector2(200, 300), 30.0 * Matrix2::Identity()}, {}, 0.0});
  list.push_back({{Vector2(204, 296), 40.0 * Matrix2::Identity()}, {}, 0.0});
  list.push_back({{Vector2(90, 100), Matrix2::Identity()}, {}, 0.0});
  const TeamBall ball = fused(list, {});
  EXPECT_EQ(ball.witnesses, 2);
  EXPECT_EQ(ball.outvoted, 1);
  EXPECT_NEAR(ball.position.x, 201.7, 0.1);
  EXPECT_NEAR(ball.position.y, 298.3, 0.1);
}

TEST(TeamBall, OneAgainstOneTheSurerIsBelieved) {
  Witnesses list;
  list.push_back({{Vector2(200, 300), 30.0 * Matrix2::Identity()}, {}, 0.0});
  list.push_back({{Vector2(90, 100), 20.0 * Matrix2::Identity()}, {}, 0.0});
  EXPECT_NEAR(fused(list, {}).position.x, 90.0, 1e-9);
  EXPECT_FALSE(fused({}, {}).present);
}

TEST(TeamBall, IsThereForARobotThatSeesNone) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.team.push_back(messageFrom(2, 1));
  WorldModel world = robot.step();
  EXPECT_FALSE(world.ball.present);
  ASSERT_TRUE(world.teamBall.present);
  EXPECT_NEAR(world.teamBall.position.x, 200.0, 1e-9);
  robot.input.team.clear();
  for (int i = 0; i < 50; ++i) world = robot.step();
  EXPECT_FALSE(world.teamBall.present);
  EXPECT_TRUE(world.teammates.empty());
}

TEST(Teammates, ArePublishedWithAVarianceThatGrows) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.team.push_back(messageFrom(3, 7));
  const WorldModel first = robot.step();
  ASSERT_EQ(first.teammates.size(), 1U);
  EXPECT_EQ(first.teammates[0].player, 3);
  EXPECT_NEAR(first.teammates[0].positionSd, 5.0, 1e-9);
  robot.input.team.clear();
  for (int i = 0; i < 29; ++i) robot.step();
  EXPECT_NEAR(robot.step().teammates[0].positionSd, std::sqrt(25.0 + 400.0), 1e-6);
}

TEST(Message, TellsOnlyWhatTheOwnCameraSaw) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.team.push_back(messageFrom(2, 1));
  for (int i = 0; i < 10; ++i) {
    const WorldModel world = robot.step();
    EXPECT_FALSE(world.message.ball.present);
    EXPECT_TRUE(world.message.opponents.empty());
  }
  EXPECT_EQ(robot.step().message.player, robot.input.game.player);
}

// Frames from one message to the next while the note of the second frame is another.
int framesToTell(const TeamNote& news) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.lastCommand.team.role = Role::striker;
  const std::uint16_t first = robot.step().message.number;
  robot.input.lastCommand.team = news;
  int frames = 1;
  while (robot.step().message.number == first) ++frames;
  return frames;
}

TEST(Message, NewsOfTheBallIsSentAtOnceAndOtherNewsEveryFifthFrame) {
  TeamNote note;
  note.role = Role::defender;
  EXPECT_EQ(framesToTell(note), 5);
  note.role = Role::attacker;
  EXPECT_EQ(framesToTell(note), 2);
  note = {};
  note.role = Role::striker;
  note.grabs = Grabs::soon;
  EXPECT_EQ(framesToTell(note), 2);
}

TEST(Message, TellsTheInformationOfAllSightingsSinceTheLast) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.percepts.robots.push_back(opponentAt(robot, 200, 220));
  WorldModel world = robot.step();
  const double once = world.message.opponents[0].covariance[3];
  while (world.message.number < 2) world = robot.step();
  ASSERT_EQ(world.message.opponents.size(), 1U);
  EXPECT_NEAR(world.message.opponents[0].covariance[3], once / 5.0, 0.1 * once);
  EXPECT_NEAR(world.message.opponents[0].position.y, 220.0, 1.0);
}

TEST(Opponents, OneInSightLeavesTheOthersWhereTheyWere) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  const double places[4][2] = {{100, 200}, {260, 210}, {180, 280}, {60, 150}};
  for (const auto& at : places) robot.percepts.robots.push_back(opponentAt(robot, at[0], at[1]));
  ASSERT_EQ(robot.step().opponents.size(), 4U);
  robot.params.players.opponents.missedNoise = 0.0;
  robot.percepts.robots.clear();
  robot.percepts.robots.push_back(opponentAt(robot, 100, 200));
  WorldModel world;
  for (int i = 0; i < 90; ++i) world = robot.step();
  ASSERT_EQ(world.opponents.size(), 4U);
  for (const auto& at : places) {
    double min = 1e9;
    for (const OpponentEstimate& o : world.opponents)
      min = std::min(min, std::hypot(o.position.x - at[0], o.position.y - at[1]));
    EXPECT_LT(min, 3.0);
  }
}

TEST(Opponents, MatesInTheOwnColourAreNotTaken) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.percepts.robots.push_back(opponentAt(robot, 200, 220));
  robot.percepts.robots[0].team = TeamColour::red;
  EXPECT_TRUE(robot.step().opponents.empty());
}

TEST(Opponents, WhatAMateSawMakesTheBeliefSurer) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.percepts.robots.push_back(opponentAt(robot, 150, 230));
  const OpponentEstimate alone = robot.step().opponents[0];
  sim::LocalisingRobot reported = robotAt(180, 100);
  reported.percepts.robots.push_back(opponentAt(reported, 150, 230));
  reported.input.team.push_back(messageFrom(2, 1));
  reported.input.team[0].opponents[0] = {{152, 232}, {100, 0, 0, 100}};
  const WorldModel world = reported.step();
  ASSERT_EQ(world.opponents.size(), 1U);
  const Place both = productOf({vectorOf(alone.position), matrixOf(alone.covariance)},
                               {Vector2(152, 232), 100.0 * Matrix2::Identity()});
  EXPECT_NEAR(world.opponents[0].covariance[0], both.covariance(0, 0), 1e-6);
  EXPECT_NEAR(world.opponents[0].covariance[3], both.covariance(1, 1), 1e-6);
  EXPECT_NEAR(world.opponents[0].position.y, both.mean(1), 1e-6);
}

// Each makes one number of a good message impossible.
using Spoil = void (*)(TeamMessage&);
class Hostile : public testing::TestWithParam<Spoil> {};

TEST_P(Hostile, MessageIsRefusedWholeAndCounted) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.team.push_back(messageFrom(2, 1));
  GetParam()(robot.input.team[0]);
  const WorldModel world = robot.step();
  EXPECT_EQ(world.counts.refused[static_cast<std::size_t>(Refusal::messageBroken)], 1);
  EXPECT_TRUE(world.teammates.empty());
  EXPECT_TRUE(world.opponents.empty());
  EXPECT_FALSE(world.teamBall.present);
  EXPECT_TRUE(std::isfinite(world.pose.position.x));
}

INSTANTIATE_TEST_SUITE_P(
    Players, Hostile,
    testing::Values([](TeamMessage& m) { m.pose.position.x = kNan; },
                    [](TeamMessage& m) { m.pose.position.y += 1000.0; },
                    [](TeamMessage& m) { m.covariance[0] = -1.0; },
                    [](TeamMessage& m) { m.covariance[8] = kInfinity; },
                    [](TeamMessage& m) { m.ball.position.x = -1000.0; },
                    [](TeamMessage& m) { m.ball.covariance[3] = kInfinity; },
                    [](TeamMessage& m) {
                      m.ball.covariance = {20, 30, 30, 20};
                    },
                    [](TeamMessage& m) { m.ball.velocity.x = kNan; },
                    [](TeamMessage& m) { m.opponents[0].position.y = kNan; },
                    [](TeamMessage& m) { m.opponents[0].covariance[0] = 0.0; },
                    [](TeamMessage& m) { m.age = kNan; }, [](TeamMessage& m) { m.age = -1.0; },
                    [](TeamMessage& m) { m.age = 2.1; }, [](TeamMessage& m) { m.player = 1; },
                    [](TeamMessage& m) { m.player = 200; }, [](TeamMessage& m) { m.number = 0; }));

TEST(Hostile, ARepeatedMessageAddsNothing) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  robot.input.team.push_back(messageFrom(2, 5));
  const double once = robot.step().opponents[0].covariance[0];
  const WorldModel world = robot.step();
  EXPECT_GT(world.opponents[0].covariance[0], once);
  EXPECT_EQ(world.counts.refused[static_cast<std::size_t>(Refusal::messageRepeated)], 1);
}

TEST(Hostile, AMessageThatWasOvertakenAddsNothingAndNumbersGoRound) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  const auto refusedAfter = [&robot](std::uint16_t number) {
    robot.input.team.clear();
    robot.input.team.push_back(messageFrom(2, number));
    return robot.step().counts.refused[static_cast<std::size_t>(Refusal::messageRepeated)];
  };
  EXPECT_EQ(refusedAfter(65534), 0);
  EXPECT_EQ(refusedAfter(65533), 1);
  EXPECT_EQ(refusedAfter(3), 1);
  EXPECT_EQ(refusedAfter(65535), 2);
}

TEST(TeamBall, AnOlderMessageSaysLessSurely) {
  const auto varianceAt = [](double age) {
    sim::LocalisingRobot robot = robotAt(180, 100);
    robot.input.team.push_back(messageFrom(2, 1));
    robot.input.team[0].age = age;
    return robot.step().teamBall.covariance[0];
  };
  const TeamBallParams params;
  EXPECT_GE(varianceAt(1.0) - varianceAt(0.0), 0.99 * params.growth);
}

TEST(Hostile, BrokenRobotPerceptsAreCountedAndLeaveAFiniteState) {
  sim::LocalisingRobot robot = robotAt(180, 100);
  const RobotPercept good = opponentAt(robot, 200, 220);
  for (int i = 0; i < 4; ++i) robot.percepts.robots.push_back(good);
  robot.percepts.robots[0].distance = kNan;
  robot.percepts.robots[1].distanceVariance = -1.0;
  robot.percepts.robots[2].headingVariance = kInfinity;
  robot.percepts.robots[3].distance = 950.0;  // far beyond the field
  const WorldModel world = robot.step();
  EXPECT_TRUE(world.opponents.empty());
  EXPECT_EQ(world.counts.refused[static_cast<std::size_t>(Refusal::opponentNotFinite)], 3);
  EXPECT_EQ(world.counts.refused[static_cast<std::size_t>(Refusal::opponentUncertain)], 1);
}

}  // namespace
}  // namespace kelpie::gps
