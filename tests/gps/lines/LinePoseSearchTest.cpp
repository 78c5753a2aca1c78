// SPDX-License-Identifier: Apache-2.0
// The search over the field by lines alone.
#include <gtest/gtest.h>

#include "gps/lines/LineMap.h"
#include "gps/lines/LinePoseSearch.h"
#include "gps/lines/PaintedField.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

int framesUntilServed(sim::StandingRobot& robot, WorldModel& world, int max) {
  for (int i = 0; i < max; ++i) {
    robot.look(false);
    world = robot.step();
    if (robot.state.lines.searchServed) return i + 1;
  }
  return -1;
}

TEST(LinePoseSearch, FindsThePoseOrItsTwinFromNowhere) {
  int found = 0;
  for (std::uint64_t seed = 500; seed < 510; ++seed) {
    sim::StandingRobot robot(seed);
    robot.input.lastCommand.localise = true;
    WorldModel world;
    if (framesUntilServed(robot, world, 400) < 0) continue;
    const bool here = sim::beliefError(world.pose, robot.truth.pose()).within(20, 10);
    const bool twin = sim::beliefError(world.pose, robot.twin()).within(20, 10);
    found += here || twin ? 1 : 0;
  }
  EXPECT_GE(found, 8);
}

TEST(LinePoseSearch, EveryModeHasItsTwinOfTheSameWeight) {
  sim::StandingRobot robot(500);
  robot.input.lastCommand.localise = true;
  WorldModel world;
  ASSERT_GT(framesUntilServed(robot, world, 400), 0);
  ASSERT_GE(world.modes.size(), 2U);
  EXPECT_NEAR(world.modes[0].weight, world.modes[1].weight, 0.01);
  const Pose2 twin = twinOf(world.modes[0].pose, robot.params.field);
  EXPECT_LT(distance(twin.position, world.modes[1].pose.position), 0.5);
}

TEST(LinePoseSearch, TakesManyFramesAndAnswersOnceForOneRequest) {
  sim::StandingRobot robot(500);
  robot.input.lastCommand.localise = true;
  WorldModel world;
  const int frames = framesUntilServed(robot, world, 400);
  ASSERT_GT(frames, 20);
  for (int i = 0; i < 100; ++i) {
    robot.look(false);
    robot.step();
    ASSERT_FALSE(robot.state.lines.search.running);
  }
  robot.input.lastCommand.localise = false;
  robot.look(false);
  robot.step();
  EXPECT_FALSE(robot.state.lines.searchServed);
}

TEST(LinePoseSearch, BeginsByItselfWhenLostAndOnlyWhileStanding) {
  sim::StandingRobot robot(501);
  for (int i = 0; i < 200; ++i) {
    robot.look(false);
    robot.input.odometry.forward = 0.5;
    robot.step();
  }
  EXPECT_TRUE(robot.state.pose.lost);
  robot.input.odometry = {};
  for (int i = 0; i < 400; ++i) {
    robot.look(false);
    robot.step();
  }
  EXPECT_FALSE(robot.state.pose.lost);
}

TEST(LinePoseSearch, AMoveDropsWhatWasBegun) {
  sim::StandingRobot robot(502);
  robot.input.lastCommand.localise = true;
  for (int i = 0; i < 400 && robot.state.lines.search.tried < 20; ++i) {
    robot.look(false);
    robot.step();
  }
  ASSERT_TRUE(robot.state.lines.search.running);
  robot.input.odometry.turn = Angle::deg(2);
  robot.step();
  EXPECT_FALSE(robot.state.lines.search.running);
  EXPECT_EQ(robot.state.lines.search.tried, 0U);
  EXPECT_TRUE(robot.state.lines.search.found.empty());
}

}  // namespace
}  // namespace kelpie::gps
