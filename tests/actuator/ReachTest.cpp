// SPDX-License-Identifier: Apache-2.0
// How far the legs swing of what is commanded, and what turns and side steps make of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/odometry/OdometryTerms.h"

namespace kelpie::actuator {
namespace {

// Every joint of the legs swings as a sine; those of `wide` a tenth further than commanded.
ReachState swinging(const std::array<double, kJointCount>& wide) {
  ReachState state;
  JointAngles commanded;
  for (int tick = 0; tick < 400; ++tick) {
    JointAngles next;
    JointAngles shown;
    for (std::size_t j = 0; j < kJointCount; ++j) {
      next.angle[j] = Angle::rad(0.5 * std::sin(0.15 * tick));
      shown.angle[j] = Angle::rad((1.0 + wide[j]) * next.angle[j].rad());
    }
    stepReach(movedBy(commanded, next), true, shown, state);
    commanded = next;
  }
  return state;
}

TEST(Reach, SaysWhichJointSwingsFurtherThanCommanded) {
  std::array<double, kJointCount> wide{};
  wide[index(Joint::leftFrontRotator)] = 0.1;
  wide[index(Joint::rightHindKnee)] = -0.1;
  const Reach reach = reachOf(swinging(wide));
  EXPECT_NEAR(reach.left.frontRotator, 0.1, 0.01);
  EXPECT_NEAR(reach.right.hindKnee, -0.1, 0.01);
  EXPECT_NEAR(reach.left.hindKnee, 0.0, 0.01);
  EXPECT_NEAR(reach.right.frontShoulder, 0.0, 0.01);
}

TEST(Reach, IsNothingWhileNobodyWalksAndAfterANumberThatIsNotFinite) {
  ReachState state;
  JointAngles broken;
  broken[Joint::leftFrontKnee] = Angle::rad(std::numeric_limits<double>::quiet_NaN());
  for (int tick = 0; tick < 50; ++tick) stepReach({}, tick > 25, broken, state);
  EXPECT_EQ(reachOf(state).left.frontKnee, 0.0);
  EXPECT_EQ(reachOf(state).right.hindRotator, 0.0);
}

TEST(Reach, OfATurnIsTheMirrorImageOfThatToTheOtherSide) {
  Felt left;
  left.reach.left.frontRotator = 0.05;
  left.reach.right.hindKnee = -0.03;
  Felt right;
  right.reach.right.frontRotator = 0.05;
  right.reach.left.hindKnee = -0.03;
  const AcrossTerms a = turnFactors({0, 0, 2}, left, 0.0);
  const AcrossTerms b = turnFactors({0, 0, -2}, right, 0.0);
  EXPECT_EQ(a.felt.legs.frontRotator, -b.felt.legs.frontRotator);
  EXPECT_EQ(a.otherLegs.hindKnee, -b.otherLegs.hindKnee);
  EXPECT_NEAR(a.felt.legs.frontRotator, 0.1, 1e-12);
}

TEST(Reach, AheadIsTheMeanOfBothSides) {
  Felt felt;
  felt.reach.left.hindRotator = 0.04;
  felt.reach.right.hindRotator = 0.02;
  EXPECT_NEAR(alongFactors({20, 0, 0}, felt, 0.0).felt.legs.hindRotator, 0.6, 1e-12);
}

}  // namespace
}  // namespace kelpie::actuator
