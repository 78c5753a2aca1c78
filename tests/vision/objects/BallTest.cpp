// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
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

TEST(Ball, NearOneIsNotBelievedBetterThanAShareOfItsDistance) {
  const Seen seen = look(ballAt(25, 0), cameraAt(16, 10, -30));
  ASSERT_TRUE(seen.percepts.ball.present);
  EXPECT_GE(std::sqrt(seen.percepts.ball.distanceVariance), 0.4);
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

TEST(Ball, NeckErrorOfFourDegreesLeavesItTheDistanceOfItsSize) {
  const auto input = std::make_unique<FrameInput>();
  const auto state = stateForPaintings();
  paint(ballAt(240, 0), cameraAt(16, 0, -8), input->image);
  const BallPercept ball = step({*input, bodyOf(cameraAt(16, 0, -12))}, {}, *state).ball;
  ASSERT_TRUE(ball.present);
  EXPECT_NEAR(ball.distance, 240, 36);  // fused with the ground's 114 it would be 149
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
  c.cone.rms = 0.99;
  EXPECT_TRUE(ballIsRound(c, p));
  c.cone.rms = 1.01;
  EXPECT_FALSE(ballIsRound(c, p));
  c.cone.radius = 3;  // whole pixels make a small circle rough
  c.cone.rms = 0.59;
  EXPECT_TRUE(ballIsRound(c, p));
  c.cone.rms = 0.61;
  EXPECT_FALSE(ballIsRound(c, p));
  c.range = p.maxDistance - 1;
  EXPECT_TRUE(ballIsNear(c, p));
  c.range = p.maxDistance + 1;
  EXPECT_FALSE(ballIsNear(c, p));
}

TEST(Ball, HalfPinkIsRefused) {
  Painting p = ballAt(60, 0);
  p.walls.push_back({{-4.5, 54}, {-0.4, 54}, 0, 12, kPinkPaint});
  const Seen seen = look(p, cameraAt(16, 0, -12));
  EXPECT_FALSE(seen.percepts.ball.present);
  EXPECT_EQ(refused(seen, Refusal::ballOtherColour), kTries);
}

TEST(Ball, BeforeOrangeTrousersIsFoundAtItsOwnDistance) {
  for (const double lateral : {-6.0, 0.0, 6.0}) {
    Painting p = ballAt(170, 0);
    p.carpetEnd = 210;
    p.noise = 3.0;
    p.walls.push_back({{lateral - 15, 240}, {lateral + 15, 240}, 3, 90, kOrangePaint});
    const Seen seen = look(p, cameraAt(16, 0, -5));
    ASSERT_TRUE(seen.percepts.ball.present) << lateral;
    EXPECT_NEAR(seen.percepts.ball.distance, 170, 17) << lateral;
    EXPECT_NEAR(seen.percepts.ball.heading.deg(), 0, 0.5) << lateral;
  }
}

// A circle of 8 px about (104, 80) filled with orange, on carpet.
struct Circle {
  Board board{cameraAt(16, 0, -8)};
  Blob blob;
  BallCandidate c;

  Circle() {
    for (int y = 72; y < 88; ++y) {
      const int half = static_cast<int>(std::sqrt(64.0 - (y + 0.5 - 80) * (y + 0.5 - 80)));
      board.fill(104 - half, y, 104 + half, y + 1, kOrangePaint);
    }
    blob.samples = 50;  // of 4 px2: the 201 px2 of the circle
    c.blob = &blob;
    c.cone.valid = true;
    c.cone.kept = 16;
    c.cone.centre = {104, 80};
    c.cone.radius = 8;
    c.range = 105;
    c.axis = body::rayThrough(board.body.camera, c.cone.centre);
  }
  BallFacts facts() const { return ballFacts(board.scene(), c); }
};

TEST(BallFacts, WholeBallIsAllOrangeOnCarpetAndAllOfItsPatch) {
  const BallFacts facts = Circle().facts();
  EXPECT_GT(facts.orange, 0.9);
  EXPECT_EQ(facts.otherColour, 0);
  EXPECT_EQ(facts.beside, 0);
  EXPECT_EQ(facts.carpetAround, 1);
  EXPECT_EQ(facts.goalBelow, 0);
  EXPECT_NEAR(facts.patch, 0, 0.02);
  EXPECT_EQ(facts.edgeShows, 0);
  EXPECT_EQ(facts.standsAlone, 1);
}

TEST(BallFacts, EdgesOfWholePixelsAreNoErrorOfTheCircle) {
  Circle circle;
  circle.c.cone.rms = 0.39;  // as in a class plane
  EXPECT_EQ(circle.facts().circleError, 0);
  circle.c.cone.rms = 0.8;
  EXPECT_NEAR(circle.facts().circleError, 0.05, 1e-9);
}

TEST(BallFacts, PatchTwiceItsCircleIsTheLogOfTwo) {
  Circle circle;
  circle.blob.samples = 100;
  EXPECT_NEAR(circle.facts().patch, std::log(2.0), 0.02);
}

TEST(BallFacts, PinkInsideTheCircleIsCounted) {
  Circle circle;
  circle.board.fill(96, 72, 104, 88, kPinkPaint);
  EXPECT_NEAR(circle.facts().otherColour, 0.5, 0.06);
}

TEST(BallFacts, ClothesThatGoOnBesideItAreOrangeThere) {
  Circle circle;
  circle.board.fill(112, 60, 130, 100, kOrangePaint);
  EXPECT_EQ(circle.facts().beside, 3.0 / 12.0);
}

TEST(BallFacts, GoalsWallBelowTheCircleShowsInAllThreePoints) {
  for (const Paint& wall : {kBluePaint, kYellowPaint}) {
    Circle circle;
    circle.board.fill(80, 88, 128, 130, wall);
    EXPECT_EQ(circle.facts().goalBelow, 1);
    EXPECT_LT(circle.facts().carpetAround, 0.6);
  }
  Circle circle;
  circle.board.fill(80, 88, 128, 130, kWhitePaint);
  EXPECT_EQ(circle.facts().goalBelow, 0);
}

TEST(BallFacts, LowestPointIsMeasuredFromTheFieldEdge) {
  Circle circle;
  circle.board.edges.push_back({72, 72, 20, 0.5});
  const BallFacts facts = circle.facts();
  EXPECT_EQ(facts.edgeShows, 1);
  EXPECT_NEAR(facts.footBelowEdge, 16, 1e-6);
  EXPECT_NEAR(facts.footBelowInRadii, 2, 1e-6);
}

TEST(BallFacts, BallOfTwiceTheSizeAtItsPlaceIsAboveTheGround) {
  Circle circle;
  const double size = circle.facts().heightError;
  EXPECT_LT(std::fabs(size), 1.0);
  circle.c.range *= 0.5;
  EXPECT_GT(circle.facts().heightError, size + 0.5);
}

TEST(BallFacts, OneWeakFactDoesNotMakeAWholeBallUnlikely) {
  const BallFacts whole = Circle().facts();
  const double limit = BallFinderParams{}.maxLogOddsAgainst;
  BallFacts rough = whole;
  rough.circleError = 0.05;
  BallFacts hidden = whole;
  hidden.orange = 0.7;
  BallFacts beforeRobot = whole;
  beforeRobot.carpetAround = 0.4;
  for (const BallFacts& facts : {whole, rough, hidden, beforeRobot})
    EXPECT_LT(logOddsAgainst(facts), limit);
}

TEST(BallFacts, SeveralWeakFactsDo) {
  BallFacts facts = Circle().facts();
  facts.circleError = 0.06;
  facts.orange = 0.5;
  facts.beside = 0.5;
  facts.carpetAround = 0.1;
  facts.patch = 1.0;
  EXPECT_GT(logOddsAgainst(facts), BallFinderParams{}.maxLogOddsAgainst);
}

}  // namespace
}  // namespace kelpie::vision
