// SPDX-License-Identifier: Apache-2.0
// What an eye makes of the true scene: things where they are, none that is hidden or out of sight,
// and the misses and errors that it is told to make.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/percepts/Looking.h"

namespace kelpie::percepts {
namespace {

const Pose2 kMiddle{{180.0, 200.0}, Angle::deg(90.0)};  // looks up the field
const Pose2 kNearGoal{{180.0, 420.0}, Angle::deg(90.0)};

TEST(Eye, WithoutErrorsTheBallIsWhereItLies) {
  Looking robot(kMiddle);
  for (const Point2<Field> place : {Point2<Field>{180.0, 260.0}, {150.0, 330.0}, {190.0, 250.0}}) {
    robot.moment.ball = place;
    const BallPercept ball = robot.see().ball;
    ASSERT_TRUE(ball.present);
    EXPECT_LT(distance(robotPolar(ball.distance, ball.heading), robot.truly(place)), 0.5);
  }
}

TEST(Eye, ABallBehindTheRobotIsNotSeen) {
  Looking robot(kMiddle);
  robot.moment.ball = {180.0, 140.0};
  EXPECT_FALSE(robot.see().ball.present);
}

TEST(Eye, ABallBehindAnotherRobotIsNotSeen) {
  Looking robot(kMiddle);
  robot.moment.ball = {180.0, 330.0};
  EXPECT_TRUE(robot.see().ball.present);
  robot.add({{187.0, 280.0}, Angle::deg(0.0)});
  EXPECT_FALSE(robot.see().ball.present);
}

TEST(Eye, WithoutErrorsABeaconIsWhereItStands) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  int seen = 0;
  for (const body::Landmark& mark : field.landmarks) {
    if (mark.kind <= LandmarkKind::goalYellow) continue;
    const Point2<Field> way = mark.position - Point2<Field>{180.0, 270.0};
    Looking robot({{180.0, 270.0}, Angle::rad(std::atan2(way.y, way.x))}, {}, Angle::deg(-2.0));
    for (const LandmarkPercept& p : robot.see().landmarks) {
      if (p.kind != mark.kind) continue;
      ++seen;
      EXPECT_LT(distance(robotPolar(p.distance, p.heading), robot.truly(mark.position)), 1.0);
    }
  }
  EXPECT_EQ(4, seen);
}

TEST(Eye, AKeeperInItDividesTheGoalIntoTwoGaps) {
  Looking robot({{180.0, 400.0}, Angle::deg(90.0)}, {}, Angle::deg(-5.0));
  const Percepts free = robot.see();
  ASSERT_EQ(1U, free.gaps.size());
  robot.add({{180.0, 530.0}, Angle::deg(270.0)});
  const Percepts kept = robot.see();
  ASSERT_EQ(2U, kept.gaps.size());
  EXPECT_LT(kept.gaps[0].right.deg(), free.gaps[0].left.deg());
  EXPECT_GT(kept.gaps[0].right.deg(), kept.gaps[1].left.deg());
}

TEST(Eye, AGoalWhosePostTheImageCutsSaysSo) {
  Looking robot({{180.0, 440.0}, Angle::deg(90.0)}, Angle::deg(25.0), Angle::deg(-5.0));
  const Percepts seen = robot.see();
  ASSERT_FALSE(seen.landmarks.empty());
  EXPECT_EQ(LandmarkKind::goalBlue, seen.landmarks.back().kind);
  EXPECT_TRUE(seen.landmarks.back().rightEdgeCut);
}

TEST(Eye, WithoutErrorsARobotFromTheSideIsWhereItsMiddleIs) {
  Looking robot(kMiddle);
  robot.add({{170.0, 290.0}, Angle::deg(0.0)}, TeamColour::blue);
  const Percepts seen = robot.see();
  ASSERT_EQ(1U, seen.robots.size());
  EXPECT_EQ(TeamColour::blue, seen.robots[0].team);
  const Point2<Robot> middle = robot.truly({166.0, 290.0});
  EXPECT_LT(distance(robotPolar(seen.robots[0].distance, seen.robots[0].heading), middle), 1.0);
}

TEST(Eye, ObstaclePointsStandAtARobotsFeet) {
  Looking robot(kMiddle);
  robot.add({{180.0, 260.0}, Angle::deg(0.0)});
  const Percepts seen = robot.see();
  ASSERT_GE(seen.obstacles.size(), 2U);
  for (const ObstaclePoint& point : seen.obstacles) EXPECT_NEAR(point.position.norm(), 60.0, 8.0);
  EXPECT_GT(seen.obstaclesAhead, 8);
}

TEST(Eye, WithoutErrorsLinePointsLieOnLines) {
  Looking robot(kNearGoal);
  const Percepts seen = robot.see();
  int lines = 0;
  for (const LinePoint& point : seen.linePoints) {
    if (point.kind != LinePointKind::line) continue;
    ++lines;
    const Point2<Field> at = fieldFromRobot(robot.moment.robots[0].pose, point.position);
    double nearest = 1e9;
    for (const body::FieldLine& line : robot.field.lines) {
      const Point2<Field> on{
          std::clamp(at.x, std::min(line.start.x, line.end.x), std::max(line.start.x, line.end.x)),
          std::clamp(at.y, std::min(line.start.y, line.end.y), std::max(line.start.y, line.end.y))};
      nearest = std::min(nearest, distance(on, at));
    }
    EXPECT_LT(nearest, 0.5);
  }
  EXPECT_GT(lines, 5);
}

TEST(Eye, ABodyThatLeansUnknownReadsLinesTooFar) {
  Looking robot(kNearGoal);
  const auto meanOf = [](const Percepts& seen) {
    double sum = 0.0;
    int count = 0;
    for (const LinePoint& p : seen.linePoints)
      if (p.kind == LinePointKind::line) sum += p.position.y, ++count;
    return sum / count;
  };
  const double level = meanOf(robot.see());
  robot.moment.robots[0].lean.tilt = Angle::deg(3.0);  // nose down: all seems higher
  EXPECT_GT(meanOf(robot.see()), level + 5.0);
}

TEST(Eye, MissesAsManyBallsAsItIsTold) {
  Looking robot(kMiddle);
  robot.moment.ball = {180.0, 300.0};
  EyeNoise noise;
  noise.ball.near.back() = 0.7;
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) seen += robot.see(noise, seed).ball.present;
  EXPECT_NEAR(seen / 500.0, 0.7, 0.07);
}

}  // namespace
}  // namespace kelpie::percepts
