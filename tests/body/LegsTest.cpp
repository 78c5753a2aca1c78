// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "robot/core/Random.h"

namespace kelpie::body {
namespace {

constexpr std::array<LegId, 4> kLegs = {LegId::leftFront, LegId::leftHind, LegId::rightFront,
                                        LegId::rightHind};
const double kKneeZero = 180.0 / maths::kPi * std::atan2(0.9, 6.95);  // the straightest leg

double apart(const Point3<Torso>& a, const Point3<Torso>& b) {
  const Point3<Torso> d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// Angles inside the soft limits with the knee bent the usual way.
LegAngles randomLeg(Random& random) {
  return {Angle::deg(random.uniform(-110, 110)), Angle::deg(random.uniform(0, 75)),
          Angle::deg(random.uniform(kKneeZero, 121))};
}

JointAngles stanceWithFrontHeight(double front, double hind) {
  JointAngles joints;
  for (const LegId leg : kLegs) {
    const bool isFront = leg == LegId::leftFront || leg == LegId::rightFront;
    const double side = leg == LegId::leftFront || leg == LegId::leftHind ? -1 : 1;
    const Point3<Torso> foot = {side * 7.5, isFront ? 0.0 : -13.0, isFront ? -front : -hind};
    setLegAngles(joints, leg, reachFoot(leg, foot).angles);
  }
  return joints;
}

TEST(Legs, AnglesComeBackFromTheFootTheyPlace) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const LegId leg = kLegs[random.index(4)];
    const LegAngles angles = randomLeg(random);
    const LegSolution back = reachFoot(leg, footPosition(leg, angles));
    ASSERT_NEAR(back.angles.knee.rad(), angles.knee.rad(), 1e-6);
    ASSERT_NEAR(back.angles.shoulder.rad(), angles.shoulder.rad(), 1e-7);
    ASSERT_NEAR((back.angles.rotator - angles.rotator).rad(), 0.0, 1e-6);
  }
}

TEST(Legs, ReachableFootIsReachedExactly) {
  Random random(12);
  int reached = 0;
  for (int i = 0; i < 2000; ++i) {
    const LegId leg = kLegs[random.index(4)];
    const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
    const double side = leg == LegId::leftFront || leg == LegId::leftHind ? -1 : 1;
    const Point3<Torso> foot = {side * random.uniform(6, 13),
                                (front ? 0 : -13) + random.uniform(-9, 9), random.uniform(-14, -3)};
    const LegSolution solution = reachFoot(leg, foot);
    if (!solution.reached) continue;
    ++reached;
    ASSERT_LT(apart(footPosition(leg, solution.angles), foot), 1e-9);
  }
  EXPECT_GT(reached, 500);
}

TEST(Legs, FootBeyondTheStretchedLegIsNotReachedAndTheLegIsStraight) {
  const LegSolution far = reachFoot(LegId::leftFront, {-6.72 - 0.47, 0.0, -40.0});
  EXPECT_FALSE(far.reached);
  const Point3<Torso> foot = footPosition(LegId::leftFront, far.angles);
  EXPECT_NEAR(std::hypot(foot.y, foot.z), std::hypot(6.95, 0.9) + 7.736, 1e-3);
}

TEST(Legs, HangingStraightDownTheFeetAreWhereTheDrawingHasThem) {
  const Point3<Torso> front = footPosition(LegId::rightFront, LegAngles{});
  EXPECT_NEAR(apart(front, {6.72 + 0.47, 0.9, -(6.95 + 7.736)}), 0.0, 1e-12);
  const Point3<Torso> hind = footPosition(LegId::leftHind, LegAngles{});
  EXPECT_NEAR(apart(hind, {-6.72 - 0.47, -13.0 - 0.9, -(6.95 + 8.314)}), 0.0, 1e-12);
}

TEST(Legs, PositiveAnglesSwingForwardLiftOutwardsAndBendAwayFromTheBody) {
  for (const LegId leg : kLegs) {
    const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
    const Point3<Torso> rest = footPosition(leg, LegAngles{});
    EXPECT_GT(footPosition(leg, {Angle::deg(10), {}, {}}).y, rest.y);
    EXPECT_GT(std::fabs(footPosition(leg, {{}, Angle::deg(10), {}}).x), std::fabs(rest.x));
    const double bent = footPosition(leg, {{}, {}, Angle::deg(30)}).y - rest.y;
    EXPECT_GT(front ? bent : -bent, 0.0);
  }
}

TEST(Legs, RightLegsAreMirrorImagesOfTheLeft) {
  Random random(13);
  for (int i = 0; i < 200; ++i) {
    const LegAngles angles = randomLeg(random);
    const Point3<Torso> lf = footPosition(LegId::leftFront, angles);
    const Point3<Torso> rf = footPosition(LegId::rightFront, angles);
    ASSERT_EQ(apart({-lf.x, lf.y, lf.z}, rf), 0.0);
    const Point3<Torso> lh = footPosition(LegId::leftHind, angles);
    const Point3<Torso> rh = footPosition(LegId::rightHind, angles);
    ASSERT_EQ(apart({-lh.x, lh.y, lh.z}, rh), 0.0);
  }
}

// facts-2005 section 2.2: shoulder 10 cm and hip 13.2 cm lean the body by 14.25 deg.
TEST(Stance, ShoulderTenAndHipThirteenLeanByFourteenDegrees) {
  JointAngles joints;
  const Stance wanted{10.0, Angle::rad(std::asin(3.2 / 13.0)), {}};
  for (const LegId leg : kLegs) {
    const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
    const double side = leg == LegId::leftFront || leg == LegId::leftHind ? -1 : 1;
    const auto foot = torsoFromRobot(wanted, {side * 8.0, front ? 1.0 : -13.0, 0.0});
    setLegAngles(joints, leg, reachFoot(leg, foot).angles);
  }
  const Stance stance = stanceFromLegs(joints);
  // Round paws carry a leg that leans higher than its tip would.
  EXPECT_NEAR(stance.bodyTilt.deg(), 14.25, 1.2);
  EXPECT_NEAR(stance.shoulderHeight, 10.2, 0.2);
}

TEST(Stance, LiftedDiagonalPairDoesNotChangeIt) {
  JointAngles joints = stanceWithFrontHeight(10.0, 12.0);
  const Stance before = stanceFromLegs(joints);
  setLegAngles(joints, LegId::leftFront, reachFoot(LegId::leftFront, {-7.5, 1.0, -7.0}).angles);
  setLegAngles(joints, LegId::rightHind, reachFoot(LegId::rightHind, {7.5, -14.0, -9.0}).angles);
  const Stance after = stanceFromLegs(joints);
  EXPECT_EQ(after.shoulderHeight, before.shoulderHeight);
  EXPECT_EQ(after.bodyTilt, before.bodyTilt);
}

TEST(Stance, NoContactIsBelowTheGround) {
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    JointAngles joints;
    for (const LegId leg : kLegs) setLegAngles(joints, leg, randomLeg(random));
    const Stance stance = stanceFromLegs(joints);
    ASSERT_TRUE(std::isfinite(stance.shoulderHeight));
    for (std::size_t s = 0; s < kSupportCount; ++s) {
      const Support support = supportOf(s, joints);
      // Feet that cross below the body leave no pair that carries it: then the chest does.
      const double low = support.radius - kPawRadius;  // is reckoned along the torso's own down
      ASSERT_GT(robotFromTorso(stance, support.middle).z, support.radius - low - 1e-9)
          << "support " << s << " round " << i;
    }
  }
}

TEST(Stance, ChestCarriesTheBodyWhenBothFrontLegsAreUp) {
  JointAngles joints = stanceWithFrontHeight(10.0, 10.0);
  for (const LegId leg : {LegId::leftFront, LegId::rightFront})
    setLegAngles(joints, leg, {Angle::deg(90), {}, Angle::deg(20)});
  const Stance stance = stanceFromLegs(joints);
  EXPECT_NEAR(stance.shoulderHeight,
              (kChestDepth - kPawRadius) * stance.bodyTilt.cos() + kPawRadius, 1e-9);
  EXPECT_GT(stance.bodyTilt.deg(), 5.0);
}

TEST(Stance, TorsoAndGroundTransformsAreInverse) {
  const Stance stance{9.3, Angle::deg(12), {}};
  const Point3<Torso> p{3, -7, -2};
  EXPECT_LT(apart(torsoFromRobot(stance, robotFromTorso(stance, p)), p), 1e-12);
  const auto neck = robotFromTorso(stance, {0, -0.25, 1.95});
  EXPECT_NEAR(neck.y, 0.0, 1e-12);
  const auto shoulder = robotFromTorso(stance, {0, 0, 0});
  EXPECT_NEAR(shoulder.z, 9.3, 1e-12);
}

TEST(Limits, EveryJointEndsInsideItsRange) {
  Random random(15);
  for (int i = 0; i < 500; ++i) {
    JointAngles joints;
    for (Angle& a : joints.angle) a = Angle::deg(random.uniform(-179, 179));
    const JointAngles limited = withinLimits(joints);
    for (std::size_t j = 0; j < kJointCount; ++j) {
      ASSERT_GE(limited.angle[j].deg(), kJointRanges[j].min - 1e-9);
      ASSERT_LE(limited.angle[j].deg(), kJointRanges[j].max + 1e-9);
    }
    ASSERT_EQ(withinLimits(limited).angle, limited.angle);
  }
}

// OPEN-R model information, spec openr.md 5.6.
TEST(Limits, ShoulderMayGoLessFarInTheFurtherTheRotatorIsFromTheMiddle) {
  EXPECT_EQ(lowestShoulder(LegId::leftFront, 20), -10);
  EXPECT_EQ(lowestShoulder(LegId::leftFront, 23), -9);
  EXPECT_EQ(lowestShoulder(LegId::rightFront, 66), -2);
  EXPECT_EQ(lowestShoulder(LegId::rightFront, -76), -1);
  EXPECT_EQ(lowestShoulder(LegId::leftHind, -16), -9) << "the robot's 16, which is backward";
  EXPECT_EQ(lowestShoulder(LegId::rightHind, 71), 0);
}

TEST(Limits, AnglesInsideStayBitForBit) {
  JointAngles joints = stanceWithFrontHeight(9.5, 12.0);
  joints[Joint::mouth] = Angle::deg(-10);
  joints[Joint::tailTilt] = Angle::deg(30);
  EXPECT_EQ(withinLimits(joints).angle, joints.angle);
}

}  // namespace
}  // namespace kelpie::body
