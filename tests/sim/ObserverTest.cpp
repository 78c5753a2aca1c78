// SPDX-License-Identifier: Apache-2.0
// What the observer sees is the truth with the errors that it says.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/sim/world/Observer.h"

namespace kelpie::sim {
namespace {

ObserverNoise withoutNoise() {
  ObserverNoise noise;
  noise.landmarkShare = noise.landmarkHeading = 0.0;
  noise.point = noise.frame = {};
  noise.ball = {0.0, 0.0, 0.0, 0.0, false};
  noise.opponents = {200.0, 1.0, 0.0, 0.0};
  return noise;
}

TEST(Observer, WithoutNoiseEveryPerceptIsTheTruth) {
  Observer robot({120.0, 150.0, 1.1}, 4, withoutNoise());
  const Point2<Field> place{150.0, 260.0};
  const Point2<Robot> truth = robotFromField(robot.truth.pose(), place);
  robot.lookAtBall(place);
  robot.lookAtOpponents({place}, 0.0);
  ASSERT_EQ(robot.percepts.robots.size(), 1U);
  for (const Point2<Robot> seen :
       {robotPolar(robot.percepts.ball.distance, robot.percepts.ball.heading),
        robotPolar(robot.percepts.robots[0].distance, robot.percepts.robots[0].heading)})
    EXPECT_LT(distance(seen, truth), 1e-9);
}

TEST(Observer, WithoutNoiseLinePointsLieOnLines) {
  Observer robot({180.0, 200.0, 1.4}, 4, withoutNoise());
  robot.lookAtLines(0.3);
  ASSERT_GT(robot.percepts.linePoints.size(), 5U);
  for (const LinePoint& point : robot.percepts.linePoints) {
    const Point2<Field> at = fieldFromRobot(robot.truth.pose(), point.position);
    double nearest = 1e9;
    for (const body::FieldLine& line : robot.field.lines) {
      const Point2<Field> way = line.end - line.start;
      const Point2<Field> from = at - line.start;
      nearest = std::min(nearest, std::fabs(way.x * from.y - way.y * from.x) / way.norm());
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(Observer, LandmarksHaveTheErrorsThatItSays) {
  Observer robot({180.0, 200.0, 1.4}, 9);
  const body::Landmark goal{LandmarkKind::goalBlue, {180.0, 540.0}};
  double share2 = 0.0;
  double heading2 = 0.0;
  constexpr int kLooks = 4000;
  for (int i = 0; i < kLooks; ++i) {
    const LandmarkPercept seen = robot.look(goal);
    share2 += maths::square(seen.distance / 340.0 - 1.0) / kLooks;
    heading2 += maths::square((seen.heading - robot.bearingOf(goal.position)).deg()) / kLooks;
  }
  EXPECT_NEAR(std::sqrt(share2), 0.06, 0.003);
  EXPECT_NEAR(std::sqrt(heading2), 2.0, 0.1);
}

TEST(Observer, WalksAsItsOdometryReportsUnlessItSlips) {
  Observer sure({100.0, 100.0, 0.0});
  ObserverNoise slipping;
  slipping.walk = {0.1, 0.0, 0.0};
  Observer slips({100.0, 100.0, 0.0}, 1, slipping);
  for (int i = 0; i < 100; ++i)
    for (Observer* one : {&sure, &slips}) one->walk(1.0, 0.0, 0.0);
  EXPECT_NEAR(sure.truth.x, 200.0, 1e-9);
  EXPECT_NEAR(slips.truth.x, 190.0, 1e-9);
  EXPECT_EQ(slips.input.odometry.forward, 1.0);
}

TEST(Observer, SeesNothingBesideItsView) {
  Observer robot({180.0, 200.0, maths::kPi / 2});
  robot.lookAround(0.0);
  for (const LandmarkPercept& seen : robot.percepts.landmarks)
    EXPECT_LT(seen.heading.abs().deg(), 28.0);
  EXPECT_FALSE(robot.inView(Angle::deg(29.0), 0.0));
  EXPECT_TRUE(robot.inView(Angle::deg(29.0), 0.1));
}

TEST(Observer, TheSameSeedSeesTheSame) {
  Observer one({150.0, 220.0, 0.4}, 12);
  Observer other({150.0, 220.0, 0.4}, 12);
  for (Observer* robot : {&one, &other}) {
    robot->lookAround(0.2);
    robot->lookAtLines(0.2);
    robot->lookAtCircleAndCarpet(0.2);
  }
  ASSERT_EQ(one.percepts.linePoints.size(), other.percepts.linePoints.size());
  for (std::size_t i = 0; i < one.percepts.linePoints.size(); ++i)
    EXPECT_EQ(one.percepts.linePoints[i].position.x, other.percepts.linePoints[i].position.x);
}

}  // namespace
}  // namespace kelpie::sim
