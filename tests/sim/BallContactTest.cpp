// SPDX-License-Identifier: Apache-2.0
// The kinematic ball off robots against the physical one.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "robot/core/Random.h"
#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::sim {
namespace {

const Pose2 kStart{{180.0, 200.0}, Angle::deg(90.0)};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void startAgain(WalkingBody& body) {
  (void)body.world().carry(0, kStart);
  body.world().bodies().putBall({{20.0, 20.0}, {}});
  for (int i = 0; i < 25; ++i) body.step({});
}

// The ball's speed 0.1 s after it met the robot, as a share of the one before; nothing if it met
// none.
std::optional<double> rebound(WalkingBody& body) {
  constexpr double kTurned = 0.3;  // of its speed that a ball loses at once: it has met something
  Point2<Field> velocity = body.world().bodies().ball().velocity;
  for (int i = 0; i < 40; ++i) {
    body.step({});
    const Point2<Field> now = body.world().bodies().ball().velocity;
    if (distance(velocity, now) > kTurned * velocity.norm()) {
      for (int k = 0; k < 3; ++k) body.step({});
      return body.world().bodies().ball().velocity.norm() / velocity.norm();
    }
    velocity = now;
  }
  return std::nullopt;
}

// Of balls from all sides, at 50 to 180 cm/s.
std::vector<double> rebounds(BodyKind kind, int balls) {
  WalkingBody body(3, {}, kind);
  Random random(7);
  std::vector<double> shares;
  for (int i = 0; i < balls; ++i) {
    startAgain(body);
    const Angle from = Angle::deg(random.uniform(-180.0, 180.0));
    const Point2<Field> side{from.cos(), from.sin()};
    const Point2<Robot> aim{random.uniform(-5.0, 5.0), random.uniform(-15.0, 3.0)};
    const Point2<Field> start = fieldFromRobot(body.pose(), aim) + side * 40.0;
    body.world().bodies().putBall({start, side * -random.uniform(50.0, 180.0)});
    if (const auto share = rebound(body)) shares.push_back(*share);
  }
  return shares;
}

// The greatest speed of balls that a robot walks into.
std::vector<double> walkedInto(BodyKind kind, int balls) {
  WalkingBody body(3, {}, kind);
  Random random(7);
  std::vector<double> speeds;
  for (int i = 0; i < balls; ++i) {
    startAgain(body);
    Command command;
    command.walk.forward = random.uniform(15.0, 45.0);
    const Point2<Robot> place{random.uniform(-8.0, 8.0), random.uniform(16.0, 22.0)};
    body.world().bodies().putBall({fieldFromRobot(body.pose(), place), {}});
    double max = 0.0;
    for (int k = 0; k < 40; ++k) {
      body.step(command);
      max = std::fmax(max, body.world().bodies().ball().velocity.norm());
    }
    speeds.push_back(max);
  }
  return speeds;
}

// Of 150 balls 0.30 and 0.25 of the speed is left.
TEST(BallContact, OffAStandingRobotABallGoesAboutAsSlowlyAsOffAPhysicalOne) {
  const std::vector<double> fast = rebounds(BodyKind::fast, 40);
  const std::vector<double> physical = rebounds(BodyKind::physical, 40);
  ASSERT_GT(fast.size(), 30U);
  ASSERT_GT(physical.size(), 30U);
  EXPECT_NEAR(mean(fast), mean(physical), 0.12);
}

// Of 60 balls 65 and 66 cm/s.
TEST(BallContact, AWalkingRobotDrivesABallAheadAsAPhysicalOneDoes) {
  const double physical = mean(walkedInto(BodyKind::physical, 30));
  EXPECT_NEAR(mean(walkedInto(BodyKind::fast, 30)), physical, 0.15 * physical);
}

}  // namespace
}  // namespace kelpie::sim
