// SPDX-License-Identifier: Apache-2.0
// The map of a standing robot: what it holds, how long, and how much it counts.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "gps/lines/LineMap.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

LinePoint pointAt(double x, double y, LinePointKind kind = LinePointKind::line) {
  return {kind, {x, y}, 1.0, {}};
}

// Its own copies of equations 3.18 and 3.19, for the test only.
bool near(const MapPoint& a, const MapPoint& b, const LineMapParams& p) {
  const double far = std::max(a.place.norm(), b.place.norm());
  const bool green = a.kind == LinePointKind::field;
  const double reach =
      green ? p.carpetRadius + p.carpetShare * far : p.radius + p.radiusShare * far;
  const double apart = (bearing(a.place) - bearing(b.place)).abs().rad();
  return distance(a.place, b.place) < reach && (green || apart < p.angle.rad());
}

void expectSound(const LineMap& map, const LineMapParams& params) {
  ASSERT_LE(map.points.size(), kMapPoints);
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    for (std::size_t j = i + 1; j < map.points.size(); ++j)
      ASSERT_FALSE(map.points[i].kind == map.points[j].kind &&
                   near(map.points[i], map.points[j], params));
  }
}

TEST(LineMap, TwoSightingsOfAPlaceBecomeOneAtTheirMean) {
  LineMap map;
  add(pointAt(0.0, 100.0), {}, map);
  add(pointAt(2.0, 103.0), {}, map);
  ASSERT_EQ(map.points.size(), 1U);
  EXPECT_NEAR(map.points[0].place.x, 1.0, 1e-12);
  EXPECT_NEAR(map.points[0].place.y, 101.5, 1e-12);
  EXPECT_EQ(map.points[0].decayedCount, 2.0);
}

TEST(LineMap, PointsApartInRadiusOrAngleOrKindStayApart) {
  LineMap map;
  add(pointAt(0.0, 100.0), {}, map);
  add(pointAt(0.0, 109.0), {}, map);  // 5.2 cm
  add(pointAt(3.5, 100.0), {}, map);  // 2.0 deg
  add(pointAt(0.0, 100.0, LinePointKind::border), {}, map);
  add(pointAt(0.0, 100.0, LinePointKind::field), {}, map);
  EXPECT_EQ(map.points.size(), 5U);
}

TEST(LineMap, AMergedPointMergesAgainWhereItHasMoved) {
  LineMap map;
  add(pointAt(0.0, 100.0), {}, map);
  add(pointAt(0.0, 106.0), {}, map);
  add(pointAt(0.0, 103.0), {}, map);  // brings the first to 101.5, near the second
  ASSERT_EQ(map.points.size(), 1U);
  EXPECT_EQ(map.points[0].decayedCount, 3.0);
  EXPECT_NEAR(map.points[0].place.y, 103.0, 1e-9);
}

TEST(LineMap, NeverHoldsMoreThanItsPointsNorTwoOfAKindInOneRegion) {
  LineMap map;
  const LineMapParams params;
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const auto kind = static_cast<LinePointKind>(random.index(3));
    add(pointAt(random.uniform(-250, 250), random.uniform(-250, 250), kind), params, map);
    if (i % 100 == 0) expectSound(map, params);
  }
  expectSound(map, params);
  EXPECT_EQ(countOf(map, LinePointKind::field), params.maxCarpet);
}

TEST(LineMap, HostilePointsAreLeftOut) {
  LineMap map;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  add(pointAt(nan, 1.0), {}, map);
  add(pointAt(1.0, std::numeric_limits<double>::infinity()), {}, map);
  add(pointAt(1e9, 1.0), {}, map);
  add({LinePointKind::line, {1.0, 2.0}, nan, {}}, {}, map);
  add({LinePointKind::line, {1.0, 2.0}, -1.0, {}}, {}, map);
  EXPECT_TRUE(map.points.empty());
  for (int i = 0; i < 256; ++i) add(pointAt(0.0, 0.0), {}, map);
  EXPECT_EQ(map.points.size(), 1U);
}

class Standing : public ::testing::Test {
 protected:
  Standing() {
    robot.params.initialPose = {true, {{185, 195}, Angle::deg(87)}, 20.0, Angle::deg(10)};
  }
  void frame(int i) {
    robot.input.odometry = {};
    robot.lookAtLines(sim::panAt(i));
    world = robot.step();
  }
  sim::LocalisingRobot robot{{180, 200, maths::kPi / 2}, 4};
  WorldModel world;
};

TEST_F(Standing, MapDoesNotStarve) {
  for (int i = 0; i < 300; ++i) {
    frame(i);
    expectSound(robot.state.lines.map, robot.params.lines.map);
    ASSERT_GE(robot.state.lines.map.points.size(), i < 60 ? 0U : 50U) << i;
  }
  EXPECT_LT(robot.error(world), 5.0);
}

TEST_F(Standing, PointsOutOfSightFadeByTheirCount) {
  for (int i = 0; i < 150; ++i) frame(i);
  const std::size_t before = robot.state.lines.map.points.size();
  robot.percepts.linePoints.clear();
  for (int i = 0; i < 150; ++i) robot.step();
  EXPECT_LT(robot.state.lines.map.points.size(), before);
  EXPECT_GT(robot.state.lines.map.points.size(), before / 4);
  for (int i = 0; i < 480; ++i) robot.step();
  EXPECT_TRUE(robot.state.lines.map.points.empty());
}

TEST_F(Standing, AStepAWalkOrAKickClearsTheMap) {
  for (int way = 0; way < 4; ++way) {
    for (int i = 0; i < 30; ++i) frame(i);
    ASSERT_GT(robot.state.lines.map.points.size(), 20U);
    robot.input.lastCommand.walk.turn = way == 0 ? 0.1 : 0.0;
    robot.input.odometry.forward = way == 1 ? 0.5 : 0.0;
    robot.input.motion.running = way == 2 ? MotionKind::kickForward : MotionKind::none;
    robot.input.lastCommand.motion = way == 3 ? MotionKind::kickForward : MotionKind::none;
    robot.step();
    EXPECT_TRUE(robot.state.lines.map.points.empty()) << way;
    robot.input.lastCommand = {};
    robot.input.motion = {};
  }
}

TEST_F(Standing, WhatTheMapHoldsCountsOnce) {
  for (int i = 0; i < 150; ++i) frame(i);
  const double sd = world.positionSd;
  robot.percepts.linePoints.clear();  // nothing new, though the map is still there
  const LineMap kept = robot.state.lines.map;
  for (int i = 0; i < 100; ++i) {
    robot.state.lines.map.points = kept.points;
    world = robot.step();
  }
  EXPECT_GT(world.positionSd, sd);
}

TEST_F(Standing, TheEstimateStaysWiderThanItsErrors) {
  double nees = 0.0;
  for (std::uint64_t run = 0; run < 20; ++run) {
    sim::LocalisingRobot other({180, 200, 1.0}, run);
    other.params.initialPose = {true, {{185, 195}, Angle::rad(1.05)}, 20.0, Angle::deg(10)};
    for (int i = 0; i < 600; ++i) {
      other.lookAtLines(sim::panAt(i));
      world = other.step();
    }
    EXPECT_GT(world.positionSd, 0.7);
    nees += maths::square(other.error(world) / world.positionSd) / 20.0;
  }
  EXPECT_LT(nees, 4.0);
}

TEST_F(Standing, AMapOfElsewhereIsGivenUp) {
  for (int i = 0; i < 100; ++i) frame(i);
  robot.truth = {100.0, 400.0, 0.3};  // carried away, and it does not notice
  bool cleared = false;
  for (int i = 0; i < 90 && !cleared; ++i) {
    frame(100 + i);
    cleared = robot.state.lines.map.age < 0.1;
  }
  EXPECT_TRUE(cleared);
}

TEST_F(Standing, AMapOfHereIsKept) {
  for (int i = 0; i < 600; ++i) frame(i);
  EXPECT_GT(robot.state.lines.map.age, 19.0);
}

TEST_F(Standing, HostilePointsLeaveAFiniteEstimate) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 200; ++i) {
    robot.percepts.linePoints.clear();
    for (int k = 0; k < 256; ++k)
      robot.percepts.linePoints.push_back(k % 3 == 0   ? pointAt(nan, 1e9)
                                          : k % 3 == 1 ? pointAt(1e9, -1e9)
                                                       : pointAt(30.0, 60.0));
    robot.input.lastCommand.localise = i > 100;
    world = robot.step();
    ASSERT_TRUE(std::isfinite(world.pose.position.x) && std::isfinite(world.positionSd));
  }
}

}  // namespace
}  // namespace kelpie::gps
