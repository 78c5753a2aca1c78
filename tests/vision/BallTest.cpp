// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/vision/Board.h"
#include "tests/vision/Painting.h"
#include "vision/Refusal.h"
#include "vision/Vision.h"
#include "vision/ball/BallFinder.h"

namespace kelpie::vision {
namespace {

constexpr double kDegree = 3.14159265358979 / 180.0;

Painting ballAt(double distance, double left) {
  Painting p;
  p.balls.push_back({-distance * std::sin(left * kDegree), distance * std::cos(left * kDegree)});
  return p;
}

// A patch is tried from its middle and from its foot; a refusal of both is counted twice.
constexpr int kTries = 2;

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

TEST(Ball, DistanceAndHeadingAreThoseOfThePaintedBall) {
  for (const double d : {25.0, 40.0, 70.0, 110.0, 160.0, 200.0}) {
    Painting p = ballAt(d, 12.0);
    p.noise = 3.0;
    const Seen seen = look(p, cameraAt(16, 10, d < 60 ? -30 : -8));
    ASSERT_TRUE(seen.percepts.ball.present) << d;
    EXPECT_NEAR(seen.percepts.ball.distance, d, 0.5 + 0.02 * d);
    EXPECT_NEAR(seen.percepts.ball.heading.deg(), 12.0, 0.3);
  }
}

TEST(Ball, IsStillSeenAt350Centimetres) {
  Painting p = ballAt(350, 0);
  p.noise = 3.0;
  const Seen seen = look(p, cameraAt(16, 3, -6));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_NEAR(seen.percepts.ball.distance, 350, 40);
  EXPECT_GT(seen.percepts.ball.distanceVariance, 400.0);
}

TEST(Ball, CutByTheImageBorderKeepsItsDistance) {
  const Seen seen = look(ballAt(45, 33), cameraAt(16, 5, -20));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_LT(seen.percepts.ball.centre.x, 20.0);
  EXPECT_NEAR(seen.percepts.ball.distance, 45, 3);
}

TEST(Ball, HalfHiddenBehindAWhiteBoxKeepsItsDistance) {
  Painting p = ballAt(80, 0);
  p.walls.push_back({{1.0, 60}, {20, 60}, 0, 20, kWhitePaint});
  const Seen seen = look(p, cameraAt(16, 0, -8));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_NEAR(seen.percepts.ball.distance, 80, 8);
}

TEST(Ball, SeenWithTheCameraRolledIsInTheSamePlace) {
  const Seen seen = look(ballAt(90, 8), cameraAt(16, 4, -10, 25));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_NEAR(seen.percepts.ball.distance, 90, 2);
  EXPECT_NEAR(seen.percepts.ball.heading.deg(), 8, 0.3);
}

TEST(Ball, NeckErrorOfOneDegreeHardlyMovesIt) {
  const auto input = std::make_unique<FrameInput>();
  const auto state = stateForPaintings();
  paint(ballAt(160, 0), cameraAt(16, 0, -8), input->image);
  for (const double up : {-9.0, -7.0}) {
    const BallPercept ball = step({*input, bodyOf(cameraAt(16, 0, up))}, {}, *state).ball;
    ASSERT_TRUE(ball.present);
    EXPECT_NEAR(ball.distance, 160, 12);  // by the ground alone it would be 124 or 226
  }
}

TEST(Ball, NoneIsSeenOnAnEmptyField) {
  Painting p;
  p.noise = 3.0;
  EXPECT_FALSE(look(p, cameraAt(16, 0, -10)).percepts.ball.present);
}

TEST(Ball, OrangeBallHeldUpInTheAirIsRefused) {
  Painting p;
  p.balls.push_back({0, 100, 45});
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_EQ(refused(seen, Refusal::ballAboveHorizon), 1);
}

TEST(Ball, BigOrangeBalloonBeyondTheFieldIsRefusedByItsSize) {
  Painting p;
  p.carpetEnd = 260;
  p.balls.push_back({0, 400, 20, 20});
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_GE(refused(seen, Refusal::ballOffGround) + refused(seen, Refusal::ballAboveFieldEdge), 1);
}

TEST(Ball, OrangeBoxIsRefused) {
  Painting p;
  p.walls.push_back({{-25, 90}, {25, 90}, 0, 12, kOrangePaint});
  EXPECT_FALSE(look(p, cameraAt(16, 0, -5)).percepts.ball.present);
}

TEST(Ball, OnAFloorWithoutGreenIsRefused) {
  Painting p = ballAt(90, 0);
  p.carpet = kFloorPaint;
  const Seen seen = look(p, cameraAt(16, 0, -8));
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_GE(refused(seen, Refusal::ballNoField), 1);
}

TEST(Ball, FarSpeckBeyondTheLimitIsRefused) {
  VisionParams params;
  params.ball.maxDistance = 150;
  const Seen seen = look(ballAt(200, 0), cameraAt(16, 0, -8), params);
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_EQ(refused(seen, Refusal::ballTooFar), kTries);
}

TEST(Ball, SmallerBlobIsTakenWhenTheLargestIsNoBall) {
  Painting p = ballAt(90, -8);
  p.walls.push_back({{-60, 90}, {-20, 90}, 0, 12, kOrangePaint});
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_NEAR(seen.percepts.ball.heading.deg(), -8, 0.5);
}

TEST(BallChecks, EdgesRoundnessAndRangeDecideAtTheirLimits) {
  const BallFinderParams p;
  BallCandidate c;
  EXPECT_FALSE(ballHasEdges(c, p));
  c.cone.valid = true;
  c.cone.kept = 5;
  EXPECT_TRUE(ballHasEdges(c, p));
  c.cone.radius = 10;
  c.cone.rms = 0.49;
  EXPECT_TRUE(ballIsRound(c, p));
  c.cone.rms = 0.51;
  EXPECT_FALSE(ballIsRound(c, p));
  c.cone.radius = 3;  // whole pixels make a small circle rough
  c.cone.rms = 0.29;
  EXPECT_TRUE(ballIsRound(c, p));
  c.cone.rms = 0.31;
  EXPECT_FALSE(ballIsRound(c, p));
  c.range = 389;
  EXPECT_TRUE(ballIsNear(c, p));
  c.range = 391;
  EXPECT_FALSE(ballIsNear(c, p));
}

TEST(Ball, BeforeOrangeTrousersIsFoundAtItsOwnDistance) {
  for (const double aside : {-6.0, 0.0, 6.0}) {
    Painting p = ballAt(170, 0);
    p.carpetEnd = 210;
    p.noise = 3.0;
    p.walls.push_back({{aside - 15, 240}, {aside + 15, 240}, 3, 90, kOrangePaint});
    const Seen seen = look(p, cameraAt(16, 0, -5));
    ASSERT_TRUE(seen.percepts.ball.present) << aside;
    EXPECT_NEAR(seen.percepts.ball.distance, 170, 17) << aside;
    EXPECT_NEAR(seen.percepts.ball.heading.deg(), 0, 0.5) << aside;
  }
}

TEST(BallChecks, PatchMuchLargerThanItsCircleIsNoBallUnlessClothesTouchIt) {
  const BallFinderParams p;
  Blob blob;
  BallCandidate c;
  c.blob = &blob;
  c.cone.radius = 10;  // 314 px2: 1.6 of it and 12 px2 are 129 samples of 4
  blob.samples = 128;
  EXPECT_TRUE(ballFillsItsPatch(c, p));
  blob.samples = 130;
  EXPECT_FALSE(ballFillsItsPatch(c, p));
  c.standsAlone = false;
  EXPECT_TRUE(ballFillsItsPatch(c, p));
}

// A circle of 6 px about (104, 80), what is below row 86 of one colour.
bool keptOver(const Paint& below) {
  Board board(cameraAt(16, 0, -8));
  board.fill(98, 74, 110, 86, kOrangePaint);
  board.fill(80, 86, 128, 110, below);
  BallCandidate c;
  c.cone.centre = {104, 80};
  c.cone.radius = 6;
  return ballStandsOnNoGoal(board.scene(), c);
}

TEST(BallChecks, OrangeOverAGoalsWallIsNoBall) {
  EXPECT_TRUE(keptOver(kGreenPaint));
  EXPECT_TRUE(keptOver(kWhitePaint));
  EXPECT_FALSE(keptOver(kBluePaint));
  EXPECT_FALSE(keptOver(kYellowPaint));
}

TEST(BallChecks, PinkInsideTheCircleIsCounted) {
  Painting p = ballAt(60, 0);
  p.walls.push_back({{-4.5, 54}, {-0.4, 54}, 0, 12, kPinkPaint});
  const Seen seen = look(p, cameraAt(16, 0, -12));
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_EQ(refused(seen, Refusal::ballOtherColour), kTries);
}

}  // namespace
}  // namespace kelpie::vision
