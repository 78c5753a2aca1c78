// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tools/learn/kick/KickLearner.h"
#include "tools/learn/motion/BallInHold.h"
#include "tools/learn/motion/GrabTrial.h"
#include "tools/learn/motion/MotionFile.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kStep = 0.002;

const actuator::MotionData& motionOf(MotionKind kind) { return actuator::standardMotions()[kind]; }

KickAim aimOf(MotionKind kind) { return aimOf(*findKick(kind), motionOf(kind)); }

KickSpread kicked(const KickAim& aim, const actuator::MotionData& motion) {
  const auto starts = beforeKicks(aim, variedModels(31, 2, kStep), 2, 31);
  return spreadOf(tryFromAll(motion, aim, starts));
}

TEST(Kick, OfTheHeadSendsABallAhead) {
  const KickSpread spread =
      kicked(aimOf(MotionKind::headSwipeLeft), motionOf(MotionKind::headSwipeLeft));
  EXPECT_GT(spread.distance, 120.0);
  EXPECT_NEAR(spread.direction.deg(), 38.0, 15.0);
  EXPECT_EQ(spread.falls, 0);
}

TEST(Kick, SendsAHeldBallAheadWithoutAFall) {
  const KickSpread spread =
      kicked(aimOf(MotionKind::hardForward), motionOf(MotionKind::hardForward));
  EXPECT_GT(spread.distance, 80.0);
  EXPECT_NEAR(spread.direction.deg(), 0.0, 10.0);
  EXPECT_EQ(spread.falls, 0);
}

TEST(Kick, AfterATurnBeginsWithTheBallHeldAndTheRobotTurned) {
  const KickAim aim = aimOf(MotionKind::hardForward);
  const auto models = variedModels(31, 2, kStep);
  for (std::uint64_t seed = 31; seed < 35; ++seed) {
    KickStart rests = beforeKick(aim, models[seed % 2], seed);
    KickStart turned = beforeKick(aim, models[seed % 2], seed, BeforeKick::turned);
    EXPECT_TRUE(holdsBall(*turned.walker));
    EXPECT_GT(std::fabs((turned.pose.heading - rests.pose.heading).deg()), 10.0);
  }
}

TEST(Kick, ToTheOtherSideSendsTheBallToTheOtherSide) {
  const KickAim aim = aimOf(MotionKind::upennLeft);
  const KickSpread left = kicked(aim, motionOf(aim.motion));
  const KickAim other = mirrored(aim);
  const KickSpread right = kicked(other, motionOf(other.motion));
  EXPECT_GT(left.direction.deg(), 25.0);
  EXPECT_LT(right.direction.deg(), -25.0);
  EXPECT_GT(right.distance, 100.0);
}

TEST(Kick, FromACopyOfTheSameInstantIsTheSame) {
  const KickAim aim = aimOf(MotionKind::upennLeft);
  const KickStart start = beforeKick(aim, variedModels(5, 1, kStep).front(), 5);
  const Kicked one = tryKick(motionOf(aim.motion), aim.motion, start);
  const Kicked two = tryKick(motionOf(aim.motion), aim.motion, start);
  EXPECT_EQ(one.distance, two.distance);
  EXPECT_EQ(one.direction.rad(), two.direction.rad());
}

TEST(KickGain, OfAKickOffItsAimOfAFallAndOfAShortOneIsLess) {
  KickAim aim;
  aim.min = Angle::deg(-5.0);
  aim.max = Angle::deg(5.0);
  const actuator::MotionData motion;
  const std::vector<Kicked> good(4, Kicked{100.0, {}, false, true, {}});
  const std::vector<Kicked> lateral(4, Kicked{100.0, Angle::deg(25.0), false, true, {}});
  const std::vector<Kicked> fell(4, Kicked{100.0, {}, true, true, {}});
  const std::vector<Kicked> near(4, Kicked{40.0, {}, false, true, {}});
  for (const auto& worse : {lateral, fell, near})
    EXPECT_LT(gainOf(worse, aim, motion), gainOf(good, aim, motion) - 0.3);
}

TEST(HeldBall, OneThatIsGivenIsHeldAndFelt) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(variedModels(8, 1, kStep).front(), params, 8);
  giveBall({0.0, kHeldAhead}, walker);
  EXPECT_TRUE(holdsBall(walker));
  EXPECT_TRUE(walker.output().status.feeling.ballHeld);
  walker.bodies().putBall({{0.0, 0.0}, {}});
  for (int i = 0; i < 9; ++i) walker.step(holdingCommand());
  EXPECT_FALSE(walker.output().status.feeling.ballHeld);
}

TEST(Grab, OfABallAtRestAheadHoldsIt) {
  const actuator::ActuatorParams params;
  Random random(4);
  PhysicalWalker walker(variedModels(4, 1, kStep).front(), params, 4);
  EXPECT_EQ(grab({{10.0, 60.0}, 0.0, {}, 1.0, MotionKind::grab}, random, walker), GrabEnd::held);
  walkWithBall(15.0, 30.0, walker);
  EXPECT_TRUE(holdsBall(walker));
}

// Thesis 2006 section 6.3.5.
TEST(Grab, ThatBeginsWithTheHeadLiftedHoldsItToo) {
  const actuator::ActuatorParams params;
  Random random(4);
  PhysicalWalker walker(variedModels(4, 1, kStep).front(), params, 4);
  EXPECT_EQ(grab({{10.0, 60.0}, 0.0, {}, 1.0, MotionKind::grabLift}, random, walker),
            GrabEnd::held);
}

}  // namespace
}  // namespace kelpie::learn
