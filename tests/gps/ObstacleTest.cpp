// SPDX-License-Identifier: Apache-2.0
// The map of obstacles: what is seen, forgotten, heard, and given to the behaviours and the team.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "gps/players/ObstacleMap.h"
#include "tests/gps/Field2006.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

struct Mapping {
  ObstacleMapParams params;
  std::unique_ptr<ObstacleMap> map = std::make_unique<ObstacleMap>();
  Percepts percepts;
  WorldModel world;

  // In the middle of the field, looking up-field.
  Mapping() {
    world.pose = {{180, 270}, Angle::deg(90)};
    world.positionSd = 5.0;
    world.headingSd = Angle::deg(2);
  }
  void seePoints(Point2<Robot> at, int count) {
    percepts = Percepts{};
    for (int i = 0; i < count; ++i) percepts.obstacles.push_back({at, {}});
    see({percepts, world}, field2006(), params, *map);
  }
  void seeCarpet(Point2<Robot> at) {
    percepts = Percepts{};
    percepts.linePoints.push_back({LinePointKind::field, at, 1.0, {}});
    see({percepts, world}, field2006(), params, *map);
  }
  double at(Point2<Field> p) const { return map->count(*cellAt(p, field2006())); }
};

TEST(ObstacleMap, PointsCountInTheCellWhereTheyLieOnTheField) {
  Mapping m;
  m.seePoints({0, 60}, 7);
  EXPECT_NEAR(m.at({180, 330}), 7.0, 1e-6);
  EXPECT_NEAR(m.at({180, 345}), 0.0, 1e-6);
  m.world.pose.heading = Angle::deg(0);
  m.seePoints({0, 60}, 3);
  EXPECT_NEAR(m.at({240, 270}), 3.0, 1e-6);
}

TEST(ObstacleMap, ARobotFartherThanPointsAreMappedIsNot) {
  Mapping m;
  RobotPercept robot;
  robot.distance = m.params.maxReach + 1.0;
  m.percepts.robots.push_back(robot);
  see({m.percepts, m.world}, field2006(), m.params, *m.map);
  EXPECT_EQ(m.at({180, 521}), 0.0);
  m.percepts.robots[0].distance = m.params.maxReach - 1.0;
  see({m.percepts, m.world}, field2006(), m.params, *m.map);
  EXPECT_GT(m.at({180, 519}), 0.0);
}

TEST(ObstacleMap, AFrameForgetsTwoInAHundred) {
  Mapping m;
  m.seePoints({0, 60}, 50);
  forget(1.0 / 30.0, m.params, *m.map);
  EXPECT_NEAR(m.at({180, 330}), 49.0, 0.05);
  forget(20.0, m.params, *m.map);
  EXPECT_EQ(m.at({180, 330}), 0.0);
}

TEST(ObstacleMap, CarpetSeenEmptiesACell) {
  Mapping m;
  m.seePoints({0, 60}, 20);
  for (int i = 0; i < 10; ++i) m.seeCarpet({0, 60});
  EXPECT_LT(m.at({180, 330}), 3.0);
  m.seePoints({0, 170}, 20);
  for (int i = 0; i < 10; ++i) m.seeCarpet({0, 170});
  EXPECT_NEAR(m.at({180, 440}), 20.0, 1e-6);  // too far to be sure that it is carpet
}

TEST(ObstacleMap, TheOwnBodyAndFarPointsAreNotMapped) {
  Mapping m;
  m.seePoints({0, m.params.minReach - 1}, 5);
  m.seePoints({0, m.params.maxReach + 1}, 5);
  EXPECT_TRUE(fullest(*m.map, field2006(), m.params).empty());
}

TEST(ObstacleMap, ARobotUnsureOfItsPlaceWritesNothing) {
  Mapping m;
  m.world.positionSd = m.params.maxPositionSd + 1;
  m.seePoints({0, 60}, 9);
  m.world.positionSd = 5;
  m.world.headingSd = m.params.maxHeadingSd + Angle::deg(1);
  m.seePoints({0, 60}, 9);
  EXPECT_EQ(m.at({180, 330}), 0.0);
}

TEST(ObstacleMap, ASeenRobotIsAnObstacle) {
  Mapping m;
  m.percepts.robots.push_back({});
  m.percepts.robots[0].distance = 80;
  m.percepts.robots[0].heading = Angle::deg(30);
  see({m.percepts, m.world}, field2006(), m.params, *m.map);
  EXPECT_GT(m.at({180 - 80 * std::sin(30 / 57.2958), 270 + 80 * std::cos(30 / 57.2958)}), 1.0);
}

TEST(ObstacleMap, WhatAMateSendsFadesSoonAndIsNotSentOn) {
  Mapping m;
  TeamMessage message;
  message.obstacles.push_back({{100, 300}, 30.0});
  hear(message, field2006(), m.params, *m.map);
  hear(message, field2006(), m.params, *m.map);
  EXPECT_NEAR(m.at({100, 300}), 30.0, 1e-6);
  EXPECT_TRUE(fullest(*m.map, field2006(), m.params).empty());
  forget(1.0, m.params, *m.map);
  EXPECT_LT(m.at({100, 300}), 5.0);
}

TEST(ObstacleMap, TellsTheFullestCellsFirst) {
  Mapping m;
  for (int i = 0; i < 30; ++i) m.seePoints({-100.0 + 8 * i, 60}, 6 + i % 7);
  const auto cells = fullest(*m.map, field2006(), m.params);
  ASSERT_GT(cells.size(), 10U);
  for (std::size_t i = 1; i < cells.size(); ++i) EXPECT_GE(cells[i - 1].count, cells[i].count);
}

TEST(ObstacleMap, PointsThatAreNoNumbersAreNotEntered) {
  Mapping m;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  m.seePoints({nan, 60}, 5);
  m.seePoints({1e300, -1e300}, 5);
  m.seeCarpet({nan, nan});
  m.world.pose.position.x = nan;
  m.seePoints({0, 60}, 5);
  for (std::size_t i = 0; i < kMapCells; ++i) ASSERT_EQ(m.map->count(i), 0.0);
}

TEST(ObstacleMap, ListsWhatItSawAndWhatItHeardApart) {
  Mapping m;
  m.seePoints({0, 60}, 7);
  TeamMessage message;
  message.obstacles.push_back({{100, 300}, 30.0});
  hear(message, field2006(), m.params, *m.map);
  const ObstacleCells cells = listed(*m.map, field2006());
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].own, 0.0);
  EXPECT_NEAR(cells[0].heard, 30.0, 1e-6);
  EXPECT_LE(distance(cells[0].position, {100, 300}), 7.1);
  EXPECT_NEAR(cells[1].own, 7.0, 1e-6);
  EXPECT_EQ(cells[1].heard, 0.0);
  EXPECT_LE(distance(cells[1].position, {180, 330}), 7.1);
}

TEST(ObstacleMap, TheOccupiedCellsAreThoseThatHoldAnythingEachOnceAndInOrder) {
  Mapping m;
  const auto expectTheCellsThatCount = [&m] {
    std::vector<std::uint16_t> counted;
    for (std::size_t cell = 0; cell < kMapCells; ++cell)
      if (m.map->count(cell) > 0.0) counted.push_back(static_cast<std::uint16_t>(cell));
    EXPECT_EQ(std::vector<std::uint16_t>(m.map->occupied.begin(), m.map->occupied.end()), counted);
  };
  TeamMessage message;
  message.obstacles.push_back({{180, 330}, 30.0});
  message.obstacles.push_back({{20, 20}, 30.0});
  message.obstacles.push_back({{200, 20}, 0.0});
  for (const double x : {60.0, -90.0, 0.0, 60.0}) m.seePoints({x, 60}, 9);
  hear(message, field2006(), m.params, *m.map);
  expectTheCellsThatCount();
  EXPECT_EQ(m.map->occupied.size(), 4U);
  m.seePoints({30, 90}, 1);
  expectTheCellsThatCount();
  forget(4.0, m.params, *m.map);  // the one point is gone, and what was heard; nine points are not
  expectTheCellsThatCount();
  EXPECT_EQ(m.map->occupied.size(), 3U);
  forget(20.0, m.params, *m.map);
  EXPECT_TRUE(m.map->occupied.empty());
}

TEST(ObstacleMap, ACellWithLessThanAPointIsNotListed) {
  Mapping m;
  m.seePoints({0, 60}, 1);
  EXPECT_EQ(listed(*m.map, field2006()).size(), 1U);
  forget(0.1, m.params, *m.map);
  EXPECT_TRUE(listed(*m.map, field2006()).empty());
}

TEST(ObstacleMap, OfMoreCellsThanTheListTakesTheFullerAreListed) {
  Mapping m;
  for (std::size_t cell = 0; cell < 2 * kObstacleCells; ++cell) {
    m.map->own[3 * cell] = cell % 4 == 0 ? 9.0F : 1.5F;
    m.map->occupied.push_back(static_cast<std::uint16_t>(3 * cell));
  }
  const ObstacleCells cells = listed(*m.map, field2006());
  ASSERT_EQ(cells.size(), kObstacleCells);
  const auto isFuller = [](const ObstacleCell& cell) { return cell.own == 9.0; };
  EXPECT_EQ(std::count_if(cells.begin(), cells.end(), isFuller), kObstacleCells / 2);
}

TEST(Obstacles, ARobotThatKnowsItsPlacePublishesWhatStandsBeforeIt) {
  sim::LocalisingRobot robot({185, 200, maths::kPi / 2});  // a cell straight ahead
  robot.params.initialPose = {true, {{185, 200}, Angle::deg(90)}, 3.0, Angle::deg(1)};
  WorldModel world;
  for (int i = 0; i < 20; ++i) {
    robot.percepts.obstacles.clear();
    robot.percepts.obstacles.push_back({{0, 40}, {}});
    world = robot.step();
  }
  ASSERT_EQ(world.obstacles.size(), 1U);
  EXPECT_LE(distance(world.obstacles[0].position, {185, 240}), 7.1);
  EXPECT_NEAR(world.obstacles[0].own, 17.0, 1.0);  // 20 less the forgetting
}

}  // namespace
}  // namespace kelpie::gps
