// SPDX-License-Identifier: Apache-2.0
// A body that others shake: the noise of the odometry grows, and only then.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "gps/pose/Shake.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

sim::LocalisingRobot standing() {
  sim::LocalisingRobot robot({180.0, 150.0, maths::kPi / 2}, 5);
  robot.params.initialPose.present = true;
  robot.params.initialPose.pose = {{180.0, 150.0}, Angle::deg(90.0)};
  robot.params.initialPose.positionSd = 5.0;
  return robot;
}

// Shaken by that much to both sides in turn for two seconds, without seeing anything.
PoseMode afterShaking(double acceleration, const ShakeParams& params = {}) {
  sim::LocalisingRobot robot = standing();
  robot.params.shake = params;
  WorldModel world;
  for (int i = 0; i < 60; ++i) {
    robot.input.sensors.acceleration[1] = i % 2 == 0 ? acceleration : -acceleration;
    robot.walk(0.67, 0.0, 0.0);
    world = robot.step();
  }
  return world.modes[0];
}

bool sameCovariance(const PoseMode& a, const PoseMode& b) {
  return std::memcmp(&a.covariance, &b.covariance, sizeof a.covariance) == 0;
}

TEST(Shake, WhoIsShakenDoubtsPlaceAndHeading) {
  const PoseMode calm = afterShaking(0.0);
  const PoseMode shaken = afterShaking(500.0);
  EXPECT_GT(shaken.covariance[0], 2.0 * calm.covariance[0]);
  EXPECT_GT(shaken.covariance[8], 2.0 * calm.covariance[8]);
}

TEST(Shake, WhoIsShakenGoesLessFarThanItsLegsWalk) {
  ShakeParams full;
  full.slowing = 0.0;
  const double legs = afterShaking(500.0, full).pose.position.y;
  EXPECT_NEAR(legs, afterShaking(0.0).pose.position.y, 1e-9);
  EXPECT_LT(afterShaking(500.0).pose.position.y, legs - 10.0);
}

TEST(Shake, AsMuchAsAFreeWalkShakesChangesNoBit) {
  EXPECT_TRUE(sameCovariance(afterShaking(0.0), afterShaking(100.0)));
}

TEST(Shake, SwitchedOffItChangesNoBit) {
  ShakeParams off;
  off.use = false;
  EXPECT_TRUE(sameCovariance(afterShaking(0.0), afterShaking(2000.0, off)));
}

TEST(Shake, ALeaningBodyIsNotShaken) {
  FrameInput input;
  input.elapsed = kFrameSeconds;
  ShakeState state;
  double excess = 0.0;
  input.sensors.acceleration[1] = 600.0;  // lies nearly on its side
  for (int i = 0; i < 90; ++i) excess = excessShake(input, ShakeParams{}, state);
  EXPECT_EQ(excess, 0.0);
}

TEST(Shake, ItEndsWithinASecond) {
  FrameInput input;
  input.elapsed = kFrameSeconds;
  ShakeState state;
  for (int i = 0; i < 60; ++i) {
    input.sensors.acceleration[1] = i % 2 == 0 ? 400.0 : -400.0;
    static_cast<void>(excessShake(input, ShakeParams{}, state));
  }
  input.sensors.acceleration[1] = 0.0;
  EXPECT_GT(excessShake(input, ShakeParams{}, state), 0.0);
  for (int i = 0; i < 30; ++i) static_cast<void>(excessShake(input, ShakeParams{}, state));
  EXPECT_EQ(excessShake(input, ShakeParams{}, state), 0.0);
}

TEST(Shake, AnAccelerationThatIsNotFiniteChangesNothing) {
  FrameInput input;
  input.elapsed = kFrameSeconds;
  ShakeState state;
  input.sensors.acceleration[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(excessShake(input, ShakeParams{}, state), 0.0);
  EXPECT_EQ(state.mean, 0.0);
  EXPECT_EQ(state.deviation, 0.0);
}

TEST(Shake, NoiseGrowsWithShakingAndTime) {
  const ShakeParams params;
  const StepNoise none{1.0, 2.0, 3.0};
  const StepNoise once = shaken(none, 1.0, 1.0, params);
  const StepNoise twice = shaken(none, 1.0, 2.0, params);
  EXPECT_DOUBLE_EQ(once.forward, 1.0 + params.pushed);
  EXPECT_DOUBLE_EQ(once.left, 2.0 + params.pushed);
  EXPECT_DOUBLE_EQ(once.turn, 3.0 + params.turned);
  EXPECT_DOUBLE_EQ(twice.turn, 3.0 + 2.0 * params.turned);
}

}  // namespace
}  // namespace kelpie::gps
