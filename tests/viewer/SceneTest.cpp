// SPDX-License-Identifier: Apache-2.0
// What is drawn, against places told by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "tests/viewer/Turning.h"
#include "tools/viewer/Beliefs.h"
#include "tools/viewer/BodyScene.h"
#include "tools/viewer/FieldScene.h"

namespace kelpie::viewer {
namespace {

constexpr double kTiny = 1e-9;
constexpr int kTrunk = 0;
constexpr int kLegs = 1;  // an upper and a lower bar of each
constexpr int kNeck = 9;
constexpr int kHead = 10;

foxglove::SceneEntity standing(double panDeg) {
  const Stance stance{12.0, {}, {}};
  JointAngles joints = standingJoints(stance);
  joints[Joint::headPan] = Angle::deg(panDeg);
  return bodyScene({}, {"red1/true", "red1 body", TeamColour::red}, joints, stance);
}

// An end of a bar, which lies along its own x axis.
Vec endOf(const foxglove::CubePrimitive& bar, double sign) {
  const auto& p = bar.pose().position();
  const Vec way = turnedBy(bar.pose().orientation(), {0.5 * sign * bar.size().x(), 0.0, 0.0});
  return {p.x() + way[0], p.y() + way[1], p.z() + way[2]};
}

TEST(BodyScene, ARobotStandsOnTheGroundBelowItsShoulders) {
  constexpr double kStop = 0.003;  // m: as far as the shoulder's stop keeps a foot outside
  const foxglove::SceneEntity robot = standing(0.0);
  ASSERT_EQ(robot.cubes_size(), kHead + 1);
  EXPECT_NEAR(robot.cubes(kTrunk).size().x(), 0.17, kTiny);
  for (int leg = 0; leg < 4; ++leg) {
    const Vec shoulder = endOf(robot.cubes(kLegs + 2 * leg), -1.0);
    const Vec foot = endOf(robot.cubes(kLegs + 2 * leg + 1), 1.0);
    EXPECT_NEAR(shoulder[2], 0.12, kTiny);
    EXPECT_NEAR(foot[2], 0.0, 1e-4);
    EXPECT_NEAR(foot[0], shoulder[0], 1e-4);
    EXPECT_NEAR(std::fabs(foot[1]), 0.0672, kStop);
  }
}

TEST(BodyScene, UpperAndLowerLegMeetInTheKnee) {
  const foxglove::SceneEntity robot = standing(0.0);
  for (int leg = 0; leg < 4; ++leg) {
    const Vec above = endOf(robot.cubes(kLegs + 2 * leg), 1.0);
    const Vec below = endOf(robot.cubes(kLegs + 2 * leg + 1), -1.0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(above[i], below[i], kTiny);
  }
}

// The nod axis of a level neck is 8 cm above the neck's base at 12 + 1.95 cm; half a face of
// 8.106 cm ahead of it is the middle of the head.
TEST(BodyScene, TheHeadLooksWhereThePanTurnsIt) {
  const auto ahead = standing(0.0).cubes(kHead).pose().position();
  EXPECT_NEAR(ahead.x(), 0.04053, kTiny);
  EXPECT_NEAR(ahead.y(), 0.0, kTiny);
  EXPECT_NEAR(ahead.z(), 0.2195, kTiny);
  const auto left = standing(88.0).cubes(kHead).pose().position();
  EXPECT_GT(left.y(), 0.0405);
  EXPECT_LT(left.x(), 0.002);
  EXPECT_NEAR(endOf(standing(0.0).cubes(kNeck), 1.0)[2], 0.2195, kTiny);
}

TEST(FieldScene, TheBlueGoalStandsBehindTheFarGoalLine) {
  const foxglove::SceneUpdate scene = fieldScene({}, *body::fieldDescription("2006"));
  const auto goal = std::find_if(scene.entities().begin(), scene.entities().end(),
                                 [](const auto& e) { return e.id() == "far goal"; });
  ASSERT_NE(goal, scene.entities().end());
  ASSERT_EQ(goal->cubes_size(), 3);  // back, left, right
  const auto& back = goal->cubes(0).pose().position();
  EXPECT_NEAR(back.x(), 1.80, kTiny);
  EXPECT_NEAR(back.y(), 5.70, kTiny);
  EXPECT_NEAR(back.z(), 0.15, kTiny);
  EXPECT_GT(goal->cubes(0).color().b(), 0.9);
}

TEST(FieldScene, ABeaconHasFourBandsThatMakeItsHeight) {
  const foxglove::SceneUpdate scene = fieldScene({}, *body::fieldDescription("2006"));
  const auto beacons = std::find_if(scene.entities().begin(), scene.entities().end(),
                                    [](const auto& e) { return e.id() == "beacons"; });
  ASSERT_EQ(beacons->cylinders_size(), 16);
  EXPECT_NEAR(beacons->cylinders(3).pose().position().z(), 0.35, kTiny);
  EXPECT_NEAR(beacons->cylinders(3).size().z(), 0.10, kTiny);
}

TEST(FieldScene, TheOldFieldHasABorder) {
  const auto linesOf = [](const char* name) {
    const foxglove::SceneUpdate scene = fieldScene({}, *body::fieldDescription(name));
    return scene.entities(1).lines_size();
  };
  EXPECT_EQ(linesOf("2006"), 2);
  EXPECT_EQ(linesOf("2004"), 3);
}

Believer believer(TeamColour team) {
  return {{}, robotName(team, 2), team, MapFrame(*body::fieldDescription("2006"), team)};
}

// One standard deviation: d' C^-1 d = 1.
TEST(Beliefs, AnEllipseIsOneStandardDeviationFromItsMiddle) {
  const auto world = std::make_unique<WorldModel>();
  PoseMode mode;
  mode.weight = 0.5;
  mode.pose = {{100.0, 200.0}, Angle::deg(90.0)};
  mode.covariance = {100.0, 60.0, 0.0, 60.0, 400.0, 0.0, 0.0, 0.0, 0.1};
  world->modes.push_back(mode);
  const auto scene = hypothesesScene(believer(TeamColour::red), *world);
  ASSERT_EQ(scene.entities(0).lines_size(), 1);
  double widest = 0.0;
  for (const auto& p : scene.entities(0).lines(0).points()) {
    const double x = 100.0 * p.x() - 100.0;
    const double y = 100.0 * p.y() - 200.0;
    const double distance =
        (400.0 * x * x - 120.0 * x * y + 100.0 * y * y) / (100.0 * 400.0 - 3600.0);
    EXPECT_NEAR(distance, 1.0, 1e-9);
    widest = std::max(widest, y);
  }
  EXPECT_NEAR(widest, 20.0, 0.3);
}

TEST(Beliefs, ABlueRobotsPosesAndBallAreTurnedIntoTheMap) {
  const auto world = std::make_unique<WorldModel>();
  PoseMode mode;
  mode.pose = {{100.0, 200.0}, Angle::deg(0.0)};
  world->modes.push_back(mode);
  world->ball.present = true;
  world->ball.position = {60.0, 40.0};
  world->ball.velocity = {0.0, 50.0};
  const Believer blue = believer(TeamColour::blue);
  const auto poses = modePoses(blue, *world);
  EXPECT_NEAR(poses.poses(0).position().x(), 2.6, kTiny);
  EXPECT_NEAR(turnedBy(poses.poses(0).orientation(), {1.0, 0.0, 0.0})[0], -1.0, kTiny);
  const auto ball = ballPose(blue, world->ball);
  EXPECT_NEAR(ball.pose().position().y(), 5.0, kTiny);
  EXPECT_NEAR(ball.pose().position().z(), 0.042, kTiny);
  EXPECT_NEAR(turnedBy(ball.pose().orientation(), {1.0, 0.0, 0.0})[1], -1.0, kTiny);
}

TEST(Beliefs, WithoutABallNothingOfItIsDrawnOn) {
  const auto scene = ballScene(believer(TeamColour::red), {});
  ASSERT_EQ(scene.entities_size(), 1);
  EXPECT_EQ(scene.entities(0).spheres_size(), 0);
}

TEST(Beliefs, ALinePointIsThreeFloatsAndAColour) {
  const auto percepts = std::make_unique<Percepts>();
  LinePoint seen;
  seen.position = {-30.0, 100.0};  // to the left, ahead
  percepts->linePoints.push_back(seen);
  const auto cloud = linePoints(believer(TeamColour::red), *percepts);
  EXPECT_EQ(cloud.frame_id(), "red2/believed");
  ASSERT_EQ(cloud.data().size(), cloud.point_stride());
  std::array<float, 3> place{};
  std::memcpy(place.data(), cloud.data().data(), sizeof place);
  EXPECT_FLOAT_EQ(place[0], 1.0F);
  EXPECT_FLOAT_EQ(place[1], 0.3F);
  EXPECT_EQ(static_cast<std::uint8_t>(cloud.data()[12]), 255);  // red of yellow
  EXPECT_EQ(static_cast<std::uint8_t>(cloud.data()[14]), 0);
}

TEST(Beliefs, WhatARobotDoesNotKnowIsAbsentFromItsNumbers) {
  const auto output = std::make_unique<FrameOutput>();
  const auto unknown = numbersOf({}, {}, *output);
  EXPECT_FALSE(unknown.has_ball_distance_m());
  EXPECT_FALSE(unknown.has_time_to_ball_s());
  output->world.ball.present = true;
  output->world.ball.distance = 83.0;
  output->command.walk.turn = 4.0;  // more than half a turn a second
  const auto known = numbersOf({}, {}, *output);
  EXPECT_DOUBLE_EQ(known.ball_distance_m(), 0.83);
  EXPECT_NEAR(known.walk_turn_deg_s(), 229.18, 0.01);
}

}  // namespace
}  // namespace kelpie::viewer
