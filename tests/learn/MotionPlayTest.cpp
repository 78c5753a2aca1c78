// SPDX-License-Identifier: Apache-2.0
// The motions that are no kicks and no grabs, played on varied physical models, and that a fall
// would be reported.
#include <gtest/gtest.h>

#include "tools/learn/motion/BlockTrial.h"
#include "tools/learn/motion/MotionScene.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kStep = 0.002;
constexpr std::uint64_t kModels = 61;  // the first of five
constexpr std::array<MotionKind, 3> kBlocks{MotionKind::block, MotionKind::blockLeft,
                                            MotionKind::blockRight};

const actuator::MotionData& dataOf(MotionKind kind) { return actuator::standardMotions()[kind]; }

sim::PhysicsParams model() { return variedModels(kModels, 1, kStep).front(); }

MotionStage standing(MotionKind kind) { return standingStage(kind, dataOf(kind), model(), 3); }

void expectStanding(MotionKind kind) {
  ASSERT_FALSE(dataOf(kind).frames.empty());
  for (const sim::PhysicsParams& varied : variedModels(kModels, 5, kStep)) {
    MotionStage stage = standingStage(kind, dataOf(kind), varied, 3);
    const MotionCourse course = playMotion(stage, false);
    EXPECT_FALSE(course.fell) << "leant " << course.lean;
    EXPECT_TRUE(course.stands) << course.height << " of " << stage.height;
    EXPECT_GT(course.rate, 50.0);  // it was played
  }
}

TEST(Motion, BlockEndsInTheStanceWithoutAFall) { expectStanding(MotionKind::block); }
TEST(Motion, BlockLeftEndsInTheStanceWithoutAFall) { expectStanding(MotionKind::blockLeft); }
TEST(Motion, BlockRightEndsInTheStanceWithoutAFall) { expectStanding(MotionKind::blockRight); }
TEST(Motion, SitEndsInTheStanceWithoutAFall) { expectStanding(MotionKind::sit); }
TEST(Motion, CheerEndsInTheStanceWithoutAFall) { expectStanding(MotionKind::cheer); }

actuator::KeyFrame keyOf(Angle leftRotator, Angle leftShoulder, Angle rightShoulder, Angle knee) {
  actuator::KeyFrame key;
  key.ticks = 60;
  key.legs = actuator::KeyLegs::angles;
  const Angle left = Angle::deg(30.0);
  key.angles = {leftRotator,     leftShoulder,  left, -leftRotator,    leftShoulder,  left,
                Angle::deg(0.0), rightShoulder, knee, Angle::deg(0.0), rightShoulder, knee};
  return key;
}

TEST(Motion, ThatLiftsTheLeftLegsAndThrowsTheRightOnesOutIsReported) {
  const auto deg = [](double value) { return Angle::deg(value); };
  actuator::MotionData motion;
  motion.frames.push_back(keyOf(deg(100.0), deg(0.0), deg(-10.0), deg(0.0)));
  motion.frames.push_back(keyOf(deg(0.0), deg(88.0), deg(88.0), deg(-20.0)));
  MotionStage stage = standingStage(MotionKind::sit, motion, model(), 3);
  EXPECT_TRUE(playMotion(stage, false).fell);
}

TEST(Motion, ThatEndsLowIsUprightButNotInTheStance) {
  MotionStage stage = sceneOf(MotionKind::hold, dataOf(MotionKind::hold), model(), 3);
  const MotionCourse course = playMotion(stage, false);
  EXPECT_TRUE(course.upright);
  EXPECT_FALSE(course.stands);
}

TEST(Block, CoversTwentyCentimetresToEachSideItIsForWithinAThirdOfASecond) {
  for (const MotionKind kind : kBlocks) {
    const BlockCover cover = coverOf(standing(kind));
    EXPECT_GT(kind == MotionKind::blockRight ? cover.right : cover.left, 20.0);
    EXPECT_GT(kind == MotionKind::blockLeft ? cover.left : cover.right, 20.0);
    EXPECT_LT(cover.seconds, 0.33);
  }
}

TEST(Block, ToOneSideReachesFurtherToItThanTheWideOne) {
  const double wide = coverOf(standing(MotionKind::block)).left;
  EXPECT_GT(coverOf(standing(MotionKind::blockLeft)).left, wide + 1.0);
}

TEST(Block, StopsABallThatPassesARobotThatStands) {
  for (const double lateral : {-15.0, 15.0}) {
    EXPECT_TRUE(tryBlock(standing(MotionKind::block), lateral, 100.0, {}).stopped);
    EXPECT_FALSE(tryBlock(standing(MotionKind::stand), lateral, 100.0, {}).stopped);
  }
}

TEST(Block, TrialLeavesTheStageAsItIs) {
  const MotionStage stage = standing(MotionKind::block);
  const BlockCover before = coverOf(stage);
  tryBlock(stage, 10.0, 100.0, {});
  const BlockCover after = coverOf(stage);
  EXPECT_EQ(before.left, after.left);
  EXPECT_EQ(before.seconds, after.seconds);
}

TEST(Scene, OfAKickHasTheBallWhereItsFileSaysAndItGoes) {
  for (const MotionKind kind : {MotionKind::upennLeft, MotionKind::headSwipeRight}) {
    MotionStage stage = sceneOf(kind, dataOf(kind), {}, 1);
    const MotionCourse course = playMotion(stage, false);
    EXPECT_NEAR(course.ballBefore.y, dataOf(kind).kick.ahead, 0.5);
    EXPECT_NEAR(course.ballBefore.x, -dataOf(kind).kick.left, 0.5);
    EXPECT_GT((course.ballRests - course.ballBefore).norm(), 100.0);
  }
}

TEST(Scene, OfAGetUpBeginsLyingAndEndsOnTheFeet) {
  const MotionKind kind = MotionKind::getUpRight;
  MotionStage stage = sceneOf(kind, dataOf(kind), {}, 1);
  const MotionCourse course = playMotion(stage, true);
  EXPECT_TRUE(stage.lies);
  EXPECT_GT(course.lean, 60.0);
  EXPECT_TRUE(course.stands);
  EXPECT_GT(course.moments.size(), ticksOf(dataOf(kind)));
}

TEST(Scene, OfAHeldKickHasTheBallUnderTheChinAndItLeaves) {
  MotionStage stage = sceneOf(MotionKind::wedge, dataOf(MotionKind::wedge), {}, 1);
  const MotionCourse course = playMotion(stage, false);
  EXPECT_LT(course.ballBefore.norm(), 11.0);
  EXPECT_FALSE(course.holds);
}

TEST(Scene, OfAGrabEndsWithTheBallHeld) {
  int touched = 0;  // a held ball moves, and the chin's switch comes and goes
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    MotionStage stage = sceneOf(MotionKind::grab, dataOf(MotionKind::grab), {}, seed);
    const MotionCourse course = playMotion(stage, false);
    EXPECT_TRUE(course.holds);
    touched += course.chin ? 1 : 0;
  }
  EXPECT_GE(touched, 2);
}

TEST(Shapes, OfAStandingRobotTouchTheCarpetAndStayOverIt) {
  MotionStage stage = standing(MotionKind::stand);
  double lowest = 100.0;
  for (const sim::Shape& shape : sim::shapesOf(stage.walker->bodies().physics(), 0))
    for (const Point3<Field>& corner : shape.corners)
      lowest = std::min(lowest, corner.z - shape.radius);
  EXPECT_NEAR(lowest, 0.0, 0.3);
}

TEST(Shapes, HaveTheLegsOnTheirSides) {
  MotionStage stage = standing(MotionKind::stand);
  for (const sim::Shape& shape : sim::shapesOf(stage.walker->bodies().physics(), 0)) {
    const Point3<Field> corner = shape.corners.front();
    const double x = robotFromField(stage.pose, {corner.x, corner.y}).x;
    const bool left =
        shape.part == sim::BodyPart::leftFront || shape.part == sim::BodyPart::leftHind;
    if (shape.part < sim::BodyPart::leftFront) continue;
    EXPECT_EQ(x < 0.0, left);
  }
}

}  // namespace
}  // namespace kelpie::learn
