// SPDX-License-Identifier: Apache-2.0
// Walking while something holds the robot: the way shrinks, the noise grows, lines wait.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "gps/Refusal.h"
#include "gps/pose/Stuck.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

const Odometry kStep{0.6, -0.2, Angle::rad(0.01), {}};

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

sim::LocalisingRobot walker(double effort) {
  sim::LocalisingRobot robot({180.0, 150.0, maths::kPi / 2}, 5);
  robot.params.initialPose.present = true;
  robot.params.initialPose.pose = {{180.0, 150.0}, Angle::deg(90.0)};
  robot.params.initialPose.positionSd = 5.0;
  robot.input.lastCommand.walk.forward = 20.0;
  robot.input.motion.effort = effort;
  return robot;
}

// Walks a second without seeing anything.
WorldModel walked(sim::LocalisingRobot& robot) {
  WorldModel world;
  for (int i = 0; i < 30; ++i) {
    robot.walk(0.67, 0.0, 0.0);
    world = robot.step();
  }
  return world;
}

TEST(Stuck, TheHarderTheLegsWorkTheLessIsWalkedAndTheMoreIsDoubted) {
  const StuckParams params;
  const StepNoise noise = stepNoise(kStep, kFrameSeconds, MotionNoise{});
  Odometry last = kStep;
  StepNoise lastNoise = noise;
  for (double excess = 0.01; excess < 0.6; excess += 0.01) {
    const Odometry now = shortened(kStep, excess, params);
    const StepNoise more = grown(noise, excess, kFrameSeconds, params);
    EXPECT_LT(now.forward, last.forward);
    EXPECT_LT(std::fabs(now.left), std::fabs(last.left));
    EXPECT_LT(now.turn.rad(), last.turn.rad());
    EXPECT_GT(now.forward, 0.0);
    EXPECT_GT(more.forward, lastNoise.forward);
    EXPECT_GT(more.left, lastNoise.left);
    EXPECT_GT(more.turn, lastNoise.turn);
    last = now;
    lastNoise = more;
  }
}

TEST(Stuck, TheEffortOfAFasterStepBeforeIsNoHold) {
  const StuckParams params;
  sim::LocalisingRobot robot = walker(freeEffort(40.0, params));
  const auto excessAt = [&](double speed) {
    robot.input.odometry = {speed * kFrameSeconds, 0.0, {}, {}};
    return excessEffort(robot.input, params, robot.state.pose.stuck, robot.state.counts);
  };
  for (int i = 0; i < 60; ++i) excessAt(40.0);
  ASSERT_GT(freeEffort(40.0, params), freeEffort(0.0, params) + params.margin);
  EXPECT_EQ(excessAt(0.0), 0.0);
  for (int i = 0; i < 60; ++i) excessAt(0.0);
  EXPECT_GT(excessAt(0.0), 0.0);
}

TEST(Stuck, FreeWalkingKeepsEveryBit) {
  const StuckParams params;
  const Odometry same = shortened(kStep, 0.0, params);
  EXPECT_TRUE(sameBits(same.forward, kStep.forward) && sameBits(same.left, kStep.left) &&
              sameBits(same.turn.rad(), kStep.turn.rad()));
  const double effort = freeEffort(20.0, params);
  sim::LocalisingRobot aware = walker(effort);
  sim::LocalisingRobot unaware = walker(effort);
  unaware.params.stuck.use = false;
  const WorldModel a = walked(aware);
  const WorldModel b = walked(unaware);
  EXPECT_TRUE(sameBits(a.pose.position.x, b.pose.position.x) &&
              sameBits(a.pose.position.y, b.pose.position.y) &&
              sameBits(a.positionSd, b.positionSd));
  EXPECT_EQ(a.stuck, 0.0);
}

TEST(Stuck, AHeldWalkIsBelievedShorterAndLessSure) {
  sim::LocalisingRobot aware = walker(0.85);
  sim::LocalisingRobot unaware = walker(0.85);
  unaware.params.stuck.use = false;
  const WorldModel a = walked(aware);
  const WorldModel b = walked(unaware);
  EXPECT_NEAR(b.pose.position.y - 150.0, 20.1, 0.1);
  EXPECT_LT(a.pose.position.y - 150.0, 0.8 * 20.1);
  EXPECT_GT(a.pose.position.y, 150.0);
  EXPECT_GT(a.positionSd, 1.5 * b.positionSd);
  EXPECT_GT(a.stuck, 0.2);
  EXPECT_EQ(b.stuck, 0.0);
}

double excessOf(sim::LocalisingRobot& robot) {
  return excessEffort(robot.input, robot.params.stuck, robot.state.pose.stuck, robot.state.counts);
}

TEST(Stuck, EffortMeansNothingWhileStandingOrInAMotion) {
  sim::LocalisingRobot robot = walker(0.9);
  EXPECT_GT(excessOf(robot), 0.0);
  robot.input.motion.running = MotionKind::kickForward;
  EXPECT_EQ(excessOf(robot), 0.0);
  robot.input.motion.running = MotionKind::none;
  robot.input.lastCommand.walk = {};
  EXPECT_EQ(excessOf(robot), 0.0);
}

TEST(Stuck, WhatNoLegsCanMakeIsRefusedAndCounted) {
  const double inf = std::numeric_limits<double>::infinity();
  std::uint16_t refused = 0;
  sim::LocalisingRobot robot = walker(0.0);
  for (const double effort : {std::nan(""), 1e9, -1.0, inf, -inf}) {
    robot.input.motion.effort = effort;
    const WorldModel world = walked(robot);
    refused = static_cast<std::uint16_t>(refused + 30);
    EXPECT_EQ(world.counts.refused[static_cast<std::size_t>(Refusal::effortNotFinite)], refused);
    EXPECT_EQ(world.stuck, 0.0);
    EXPECT_TRUE(std::isfinite(world.pose.position.y) && std::isfinite(world.positionSd));
  }
}

// The pause alone, frame by frame.
struct Pause {
  Pause() { params.pauseSeconds = 2.0; }
  void frames(int count, double excess) {
    for (int i = 0; i < count; ++i) stepStuck(excess, kFrameSeconds, params, state);
  }
  StuckParams params;
  StuckState state;
};

TEST(Stuck, LinesWaitForTheTimeAfterTheRobotIsFree) {
  Pause pause;
  pause.frames(30, 0.0);
  EXPECT_FALSE(pause.state.paused);
  pause.frames(30, 0.3);
  EXPECT_TRUE(pause.state.paused);
  pause.frames(58, 0.0);
  EXPECT_TRUE(pause.state.paused);
  pause.frames(3, 0.0);
  EXPECT_FALSE(pause.state.paused);
}

TEST(Stuck, LandmarksThatConfirmThePoseEndThePauseButNotWhileStuck) {
  Pause pause;
  pause.frames(10, 0.3);
  for (int i = 0; i < 10; ++i) confirm(pause.params, pause.state);
  EXPECT_TRUE(pause.state.paused);
  pause.frames(1, 0.0);
  for (std::uint32_t i = 0; i < pause.params.pauseLandmarks; ++i) {
    EXPECT_TRUE(pause.state.paused);
    confirm(pause.params, pause.state);
  }
  EXPECT_FALSE(pause.state.paused);
}

TEST(Stuck, NoPauseIsMadeOfNoSeconds) {
  Pause pause;
  pause.params.pauseSeconds = 0.0;
  pause.frames(30, 0.5);
  EXPECT_FALSE(pause.state.paused);
}

// Lines before the same robot are used, and not used in the pause.
TEST(Stuck, PausedLinesCorrectNothing) {
  double sd[2];
  for (const bool paused : {false, true}) {
    sim::LocalisingRobot robot = walker(0.0);
    robot.state.pose.stuck.paused = paused;
    robot.params.stuck.pauseSeconds = paused ? 10.0 : 0.0;
    for (int frame = 0; frame < 10; ++frame) {
      robot.lookAtLines(0.0);
      sd[paused ? 1 : 0] = robot.step().positionSd;
    }
  }
  EXPECT_LT(sd[0], 0.9 * sd[1]);
}

}  // namespace
}  // namespace kelpie::gps
