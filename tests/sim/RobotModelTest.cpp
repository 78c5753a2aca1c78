// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "tests/sim/Targets.h"
#include "tools/sim/bodies/RobotModel.h"

namespace kelpie::sim {
namespace {

// A body that follows its targets at once and does not slip.
RobotParams ideal() {
  RobotParams params;
  params.ground = GroundParams::plain();
  params.lagTicks = 0.0;
  params.headRate = params.legRate = 1000.0;
  params.jointNoiseSd = params.slipMean = params.slipSd = params.driftSd = 0.0;
  return params;
}

// Feet of a level body, shoulder axis 11 cm high; `shift` moves them on the ground, lifted feet by
// z.
JointAngles standing(const std::array<Point3<Torso>, kLegCount>& shift) {
  constexpr std::array<Point3<Torso>, kLegCount> kHome{
      {{-8, 2, -11}, {-8, -12, -11}, {8, 2, -11}, {8, -12, -11}}};
  JointAngles joints = startingPose();
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const Point3<Torso> foot = kHome[i] + shift[i];
    const auto angles = body::reachFoot(leg, foot).angles;
    EXPECT_NEAR(body::footPosition(leg, angles).y, foot.y, 1e-9);
    EXPECT_NEAR(body::footPosition(leg, angles).x, foot.x, 1e-9);
    body::setLegAngles(joints, leg, angles);
  }
  return joints;
}

void settle(RobotModel& robot, const JointAngles& joints) {
  robot.command(targets(joints));
  robot.tick();
}

TEST(RobotModel, FeetThatPushBackCarryTheBodyForward) {
  RobotModel robot(ideal(), {{100, 100}, Angle::deg(90)}, 1);
  settle(robot, standing({}));
  const Pose2 start = robot.place().pose;
  for (int i = 1; i <= 10; ++i) {
    const Point3<Torso> back{0, -0.2 * i, 0};
    settle(robot, standing({back, back, back, back}));
  }
  const Point2<Robot> moved = robotFromField(start, robot.place().pose.position);
  // The tips of the legs go 2 cm; round paws roll on as the legs turn by 0.27 rad.
  EXPECT_NEAR(moved.y, 2.27, 0.05);
  EXPECT_NEAR(moved.x, 0.0, 1e-6);
  EXPECT_NEAR((robot.place().pose.heading - start.heading).rad(), 0.0, 1e-9);
}

// Of ten ticks that push back, and ten that stand.
Pose2 movedWith(const BodyFaults& faults) {
  RobotModel robot(ideal(), {{100, 100}, Angle::deg(90)}, 1, faults);
  settle(robot, standing({}));
  const Pose2 start = robot.place().pose;
  Point3<Torso> back{};
  for (int i = 1; i <= 20; ++i) {
    if (i <= 10) back = {0, -0.2 * i, 0};
    settle(robot, standing({back, back, back, back}));
  }
  const Point2<Robot> moved = robotFromField(start, robot.place().pose.position);
  return {{moved.x, moved.y}, robot.place().pose.heading - start.heading};
}

TEST(RobotModel, AStrideOfItsOwnCarriesItFartherAndTurnsItWhileItWalks) {
  BodyFaults faults;
  const double usual = movedWith(faults).position.y;
  faults.stride = {1.2, {}};
  EXPECT_NEAR(movedWith(faults).position.y, 1.2 * usual, 1e-6);
  faults.stride = {1.0, Angle::deg(0.3)};
  const double frames = 10 * kTickSeconds / kFrameSeconds;
  EXPECT_NEAR(movedWith(faults).heading.deg(), 0.3 * frames, 1e-6);
}

TEST(RobotModel, DiagonalPairCarriesAloneWhileTheOtherSwings) {
  RobotModel robot(ideal(), {{100, 100}, Angle::deg(0)}, 1);
  settle(robot, standing({}));
  const Pose2 start = robot.place().pose;
  for (int i = 1; i <= 10; ++i) {
    const Point3<Torso> back{0.05 * i, -0.2 * i, 0};
    const Point3<Torso> swing{-0.1 * i, 0.2 * i, 1.5};
    settle(robot, standing({back, swing, swing, back}));
  }
  const Point2<Robot> moved = robotFromField(start, robot.place().pose.position);
  // Two feet of a diagonal carry the body; the lifted ones do not drag it.
  EXPECT_NEAR(moved.y, 2.25, 0.05);
  EXPECT_NEAR(moved.x, -0.5, 0.01);
  EXPECT_FALSE(robot.onGround()[1]);
  EXPECT_TRUE(robot.onGround()[0]);
}

TEST(RobotModel, FeetThatCircleTurnTheBody) {
  RobotModel robot(ideal(), {{100, 100}, Angle::deg(0)}, 1);
  settle(robot, standing({}));
  std::array<Point3<Torso>, kLegCount> shift{};
  constexpr std::array<Point2<Torso>, kLegCount> kFeet{{{-8, 2}, {-8, -12}, {8, 2}, {8, -12}}};
  const double turn = 0.03;  // the feet turn right about the shoulder axis' middle, the body left
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const double x = std::cos(turn) * kFeet[i].x + std::sin(turn) * kFeet[i].y;
    const double y = -std::sin(turn) * kFeet[i].x + std::cos(turn) * kFeet[i].y;
    shift[i] = {x - kFeet[i].x, y - kFeet[i].y, 0};
  }
  settle(robot, standing(shift));
  EXPECT_NEAR(robot.place().pose.heading.rad(), turn, 0.1 * turn);  // and a little rolled
}

TEST(RobotModel, WithoutPowerJointsStay) {
  RobotModel robot(ideal(), {}, 1);
  robot.command(targets(startingPose()));  // from now on no hand is at it
  for (int i = 0; i < 2; ++i) robot.tick();
  const JointAngles before = robot.place().joints;
  host::AgentReply reply = targets(standing({}));
  reply.motorPower = false;
  robot.command(reply);
  for (int i = 0; i < 5; ++i) robot.tick();
  for (std::size_t j = 0; j < kJointCount; ++j) {
    EXPECT_EQ(robot.place().joints.angle[j].rad(), before.angle[j].rad());
  }
}

TEST(RobotModel, VectorsPlayInTurnAndAreCounted) {
  RobotModel robot(ideal(), {}, 1);
  host::AgentReply reply = targets(startingPose());
  reply.vectors[0].joints = 1U << index(Joint::headPan);
  reply.vectors[0].ticks = 4;
  for (std::size_t t = 0; t < 4; ++t) {
    JointAngles wanted;
    wanted[Joint::headPan] = Angle::deg(static_cast<double>(t + 1));
    reply.vectors[0].targets[t] = host::rawOf(wanted);
  }
  reply.vectors.push_back(reply.vectors[0]);
  robot.command(reply);
  for (int t = 0; t < 3; ++t) robot.tick();
  EXPECT_NEAR(robot.place().joints[Joint::headPan].deg(), 3.0, 1e-4);
  EXPECT_EQ(robot.queue().takeVectorsDone(), 0U);
  for (int t = 0; t < 5; ++t) robot.tick();
  EXPECT_EQ(robot.queue().takeVectorsDone(), 2U);
  for (int t = 0; t < 5; ++t) robot.tick();
  EXPECT_NEAR(robot.place().joints[Joint::headPan].deg(), 4.0, 1e-4);  // holds
  EXPECT_EQ(robot.queue().vectorsWaiting(), 0U);
}

TEST(RobotModel, ServosAreLateAndLimited) {
  RobotParams params = ideal();
  params.lagTicks = 2.0;
  params.headRate = 5.0;
  RobotModel robot(params, {}, 1);
  JointAngles wanted = startingPose();
  wanted[Joint::headPan] = Angle::deg(60);
  robot.command(targets(wanted));
  robot.tick();
  EXPECT_NEAR(robot.place().joints[Joint::headPan].rad(), 5.0 * 0.008, 1e-9);
  for (int i = 0; i < 60; ++i) robot.tick();
  EXPECT_NEAR(robot.place().joints[Joint::headPan].deg(), 60.0, 0.01);
}

}  // namespace
}  // namespace kelpie::sim
