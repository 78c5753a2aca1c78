// SPDX-License-Identifier: Apache-2.0
// A walk replayed: what the localiser believed when its figures were measured, to half a
// centimetre and half a degree. Whoever changes the filter on purpose measures the experiments
// again and takes the new numbers from the test's message.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

struct Believed {
  int frame;
  Pose2 pose;
  Point2<Field> ball;
};

BallPercept ballSeen(const sim::LocalisingRobot& robot, Point2<Field> ball) {
  const Pose2 truth{{robot.truth.x, robot.truth.y}, Angle::rad(robot.truth.heading)};
  const Point2<Robot> at = robotFromField(truth, ball);
  BallPercept percept;
  percept.present = true;
  percept.distance = at.norm();
  percept.heading = bearing(at);
  percept.distanceVariance = maths::square(0.03 * percept.distance);
  percept.headingVariance = 1e-4;
  return percept;
}

// An arc through the middle of the field with a panning head, landmarks and lines in sight.
WorldModel walkOneFrame(sim::LocalisingRobot& robot, int frame, Random& random) {
  robot.walk(0.7, 0.1, 0.008);
  robot.lookAround(sim::panAt(frame));
  robot.falsify(0.05, random);
  robot.lookAtLines(sim::panAt(frame));
  robot.percepts.ball = frame % 60 < 30 ? ballSeen(robot, {200, 330}) : BallPercept{};
  return robot.step();
}

void expectNear(const WorldModel& world, const Believed& golden) {
  const double turn = (world.pose.heading - golden.pose.heading).abs().deg();
  const bool same = distance(world.pose.position, golden.pose.position) < 0.5 && turn < 0.5 &&
                    distance(world.ball.position, golden.ball) < 1.0;
  EXPECT_TRUE(same) << "{" << golden.frame << ", {{" << world.pose.position.x << ", "
                    << world.pose.position.y << "}, Angle::deg(" << world.pose.heading.deg()
                    << ")}, {" << world.ball.position.x << ", " << world.ball.position.y << "}}";
}

TEST(Golden, AWalkIsBelievedAsWhenItWasMeasured) {
  const Believed golden[] = {
      {60, {{150.6, 242.4}, Angle::deg(96.2)}, {201.3, 330.3}},
      {150, {{114.1, 293.0}, Angle::deg(138.4)}, {199.8, 331.3}},
      {240, {{53.6, 307.7}, Angle::deg(178.7)}, {200.4, 329.8}},
  };
  sim::LocalisingRobot robot({150, 200, 1.2}, 77);
  Random random(78);
  std::size_t next = 0;
  for (int frame = 1; frame <= 240; ++frame) {
    const WorldModel world = walkOneFrame(robot, frame, random);
    if (frame != golden[next].frame) continue;
    expectNear(world, golden[next++]);
    EXPECT_LT(robot.error(world), 8.0);  // and the golden belief itself is near the truth
  }
  EXPECT_EQ(next, 3U);
}

}  // namespace
}  // namespace kelpie::gps
