// SPDX-License-Identifier: Apache-2.0
// The map of obstacles: what is seen, forgotten, heard, and what behaviours are told of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "gps/players/ObstacleQueries.h"
#include "tests/gps/Field2006.h"
#include "tools/sim/LocalisingRobot.h"

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
  ObstacleView view() const { return {*map, field2006(), params}; }
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

TEST(ObstacleMap, GoalsAndBeaconsAlwaysStandInIt) {
  Mapping m;
  build(field2006(), m.params, *m.map);
  EXPECT_NEAR(m.at({180, 571}), 40.0, 1e-6);                    // the far goal's back wall
  EXPECT_NEAR(m.at({-15, 135}), 40.0, 1e-6);                    // a beacon
  EXPECT_NEAR(m.at({180, 545}), 0.0, 1e-6);                     // its mouth is free
  EXPECT_TRUE(fullest(*m.map, field2006(), m.params).empty());  // nobody needs to be told
}

TEST(ObstacleMap, WhatAMateTellsFadesSoonAndIsNotToldOn) {
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

TEST(ObstacleQueries, ACorridorCountsWhatStandsInItsWidthOnly) {
  Mapping m;
  m.seePoints({0, 60}, 12);
  const Point2<Field> me = m.world.pose.position;
  EXPECT_NEAR(countInCorridor(m.view(), me, {180, 400}), 12.0, 1e-6);
  EXPECT_NEAR(countInCorridor(m.view(), me, {180, 300}), 0.0, 1e-6);
  EXPECT_NEAR(countInCorridor(m.view(), me, {280, 400}), 0.0, 1e-6);
}

TEST(ObstacleQueries, MoreObstaclesNeverMakeACorridorFreer) {
  Mapping m;
  double last = 0.0;
  for (int i = 0; i < 20; ++i) {
    m.seePoints({-30.0 + 3.0 * i, 60}, 4);
    const double now = countInCorridor(m.view(), m.world.pose.position, {180, 400});
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_GT(last, 0.0);
}

TEST(ObstacleQueries, SectorsAreCountedFromTheRobotsHeading) {
  Mapping m;
  m.seePoints(robotPolar(60, Angle::deg(60)), 15);
  const Sectors sectors = sectorsAround(m.view(), m.world.pose);
  EXPECT_NEAR(sectors[6].count, 15.0, 1e-6);
  EXPECT_NEAR(sectors[6].nearest, 60.0, 8.0);
  EXPECT_NEAR(countInSector(sectors, Angle::deg(60), Angle::deg(30)), 15.0, 1e-6);
  EXPECT_NEAR(countInSector(sectors, Angle::deg(-60), Angle::deg(30)), 0.0, 1e-6);
}

TEST(ObstacleQueries, TheBestGapIsTheWishedWayWhenItIsFree) {
  const Sectors free{};
  const ObstacleGap gap = bestGap(free, Angle::deg(25), {});
  ASSERT_TRUE(gap.present);
  EXPECT_NEAR(gap.heading.deg(), 25.0, 1e-9);
}

TEST(ObstacleQueries, AGapAllAroundIsAsWideAsAnAngleCanSay) {
  EXPECT_NEAR(bestGap(Sectors{}, Angle::deg(0), {}).width.deg(), 180.0, 1e-9);
}

TEST(ObstacleQueries, TheBestGapPassesAnObstacleOnTheNearerSide) {
  Sectors sectors{};
  for (const std::size_t i : {0U, 1U, 35U, 34U, 33U}) sectors[i].nearest = 40.0;
  const ObstacleGap gap = bestGap(sectors, Angle::deg(0), {});
  ASSERT_TRUE(gap.present);
  EXPECT_NEAR(gap.heading.deg(), 25.0, 1e-6);  // left: free from 15 deg, and half of 20 more
  sectors[1].nearest = 51.0;                   // farther than the gap's reach
  EXPECT_NEAR(bestGap(sectors, Angle::deg(0), {}).heading.deg(), 15.0, 1e-6);
}

TEST(ObstacleQueries, ThereIsNoGapWhereAllWaysAheadAreBlockedOrTooNarrow) {
  Sectors sectors{};
  for (std::size_t i = 0; i < kObstacleSectors; i += 2) sectors[i].nearest = 30.0;
  EXPECT_FALSE(bestGap(sectors, Angle::deg(0), {}).present);
  ObstacleMapParams narrow;
  narrow.gapWidth = Angle::deg(10);
  EXPECT_TRUE(bestGap(sectors, Angle::deg(0), narrow).present);
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
  EXPECT_LT(world.obstacles.sectors[0].nearest, 50.0);
  EXPECT_GT(world.obstacles.toGoal, 10.0);
  ASSERT_TRUE(world.obstacles.gapToGoal.present);
  EXPECT_GT(std::fabs(world.obstacles.gapToGoal.heading.deg()), 10.0);
  EXPECT_FALSE(world.obstacles.cells.empty());
}

}  // namespace
}  // namespace kelpie::gps
