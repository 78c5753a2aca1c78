// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/Board.h"
#include "tests/vision/Painting.h"
#include "vision/Refusal.h"
#include "vision/goal/GoalCurves.h"
#include "vision/goal/GoalFinder.h"
#include "vision/goal/GoalShape.h"

namespace kelpie::vision {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979;

Painting goalAt(double x, double y, Paint colour) {
  Painting p;
  p.carpetEnd = y + 30.0;
  addGoal(p, x, y, colour);
  return p;
}

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

TEST(Goal, DistanceHeadingAndPostsAreThoseOfThePaintedOne) {
  for (const double y : {200.0, 300.0, 400.0, 480.0}) {
    Painting p = goalAt(20, y, kYellowPaint);
    p.noise = 3.0;
    const Seen seen = look(p, cameraAt(16, 0, -4));
    const auto* goal = find(seen.percepts, LandmarkKind::goalYellow);
    ASSERT_NE(goal, nullptr) << y;
    EXPECT_NEAR(goal->distance, std::hypot(20, y), 0.05 * y);
    EXPECT_NEAR(goal->heading.deg(), std::atan2(-20, y) * kDegrees, 0.8);
    EXPECT_NEAR(goal->leftEdge.deg(), std::atan2(20, y) * kDegrees, 0.8);
    EXPECT_NEAR(goal->rightEdge.deg(), std::atan2(-60, y) * kDegrees, 0.8);
    EXPECT_FALSE(goal->leftEdgeCut || goal->rightEdgeCut);
  }
}

TEST(Goal, SeenFromTheSideIsPlacedWithinASixth) {
  Painting p = goalAt(180, 180, kBluePaint);
  const Seen seen = look(p, cameraAt(16, -45, -4));
  const auto* goal = find(seen.percepts, LandmarkKind::goalBlue);
  ASSERT_NE(goal, nullptr);
  EXPECT_NEAR(goal->distance, 254.6, 42);
  EXPECT_NEAR(goal->heading.deg(), -45, 4);
}

TEST(Goal, PostBeyondTheImageBorderIsMarkedAsCut) {
  const Seen seen = look(goalAt(60, 120, kBluePaint), cameraAt(16, 0, -5));
  const auto* goal = find(seen.percepts, LandmarkKind::goalBlue);
  ASSERT_NE(goal, nullptr);
  EXPECT_TRUE(goal->rightEdgeCut);
  EXPECT_FALSE(goal->leftEdgeCut);
  EXPECT_NEAR(goal->heading.deg(), std::atan2(-60, 120) * kDegrees, 7);
}

constexpr Paint kPaleBluePaint{82, 122, 148};

TEST(Goal, OfThePalerBlueOfClothAndBoardsIsRefused) {
  EXPECT_NE(
      find(look(goalAt(0, 250, kBluePaint), cameraAt(16, 0, -4)).percepts, LandmarkKind::goalBlue),
      nullptr);
  EXPECT_EQ(find(look(goalAt(0, 250, kPaleBluePaint), cameraAt(16, 0, -4)).percepts,
                 LandmarkKind::goalBlue),
            nullptr);
}

TEST(Goal, EndsWhereThePalerBlueBehindItBegins) {
  Painting p = goalAt(0, 250, kBluePaint);
  p.walls.push_back({{-40, 290}, {40, 290}, 0, 40, kPaleBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, -4));
  const auto* goal = find(seen.percepts, LandmarkKind::goalBlue);
  ASSERT_NE(goal, nullptr);
  EXPECT_NEAR(goal->distance, 250, 12);  // with the wall's top it would be 190
}

TEST(Goal, SplitByAWhiteGoalieIsOne) {
  Painting p = goalAt(0, 250, kYellowPaint);
  p.walls.push_back({{-8, 230}, {8, 230}, 0, 40, kWhitePaint});
  const Seen seen = look(p, cameraAt(16, 0, -4));
  const auto* goal = find(seen.percepts, LandmarkKind::goalYellow);
  ASSERT_NE(goal, nullptr);
  EXPECT_NEAR(goal->heading.deg(), 0, 1);
  EXPECT_NEAR(goal->leftEdge.deg() - goal->rightEdge.deg(), 18.2, 1.5);
}

TEST(Goal, BothGoalsHaveTheirOwnKind) {
  EXPECT_NE(
      find(look(goalAt(0, 200, kBluePaint), cameraAt(16, 0, 0)).percepts, LandmarkKind::goalBlue),
      nullptr);
  EXPECT_EQ(
      find(look(goalAt(0, 200, kBluePaint), cameraAt(16, 0, 0)).percepts, LandmarkKind::goalYellow),
      nullptr);
}

TEST(Goal, BlueWindowHighOnTheWallIsRefusedByItsTallColumns) {
  Painting p;
  p.carpetEnd = 300;
  p.walls.push_back({{-60, 600}, {60, 600}, 120, 180, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, 8));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalAspect), 1);
}

TEST(Goal, FlatBlueWindowHighOnTheWallIsRefusedByItsFoot) {
  Painting p;
  p.carpetEnd = 300;
  p.walls.push_back({{-50, 600}, {50, 600}, 120, 145, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, 8));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalAboveHorizon), 1);
}

TEST(Goal, BlueTrousersAreRefusedByTheirShape) {
  Painting p;
  p.carpetEnd = 250;
  p.walls.push_back({{-10, 330}, {10, 330}, 0, 85, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, 5));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalAspect), 1);
}

TEST(Goal, WithoutGreenBelowIsRefused) {
  Painting p = goalAt(0, 200, kBluePaint);
  p.carpet = kFloorPaint;
  const Seen seen = look(p, cameraAt(16, 0, -2));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalNoField), 1);
}

TEST(Goal, BandOfABeaconIsNoGoal) {
  Painting p;
  p.carpetEnd = 110;
  p.beacons.push_back({{0, 110}, kBluePaint, kPinkPaint});
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_EQ(find(seen.percepts, LandmarkKind::goalBlue), nullptr);
  ASSERT_EQ(seen.percepts.landmarks.size(), 1U);
}

TEST(Goal, BandUnderPinkIsNoGoalEither) {
  Painting p;
  p.beacons.push_back({{0, 110}, kPinkPaint, kBluePaint});
  p.beacons[0].lift = -20;  // sunk to its blue band
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalIsBeacon), 1);
}

TEST(Goal, NarrowBlueBoxAsHighAsAGoalIsRefusedByItsWidth) {
  Painting p;
  p.walls.push_back({{-9, 200}, {9, 200}, 0, 30, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalWidth), 1);
}

TEST(Goal, MiddleOfOneWhoseEndsAreHiddenIsNotTakenForATurnedOne) {
  Painting p;
  p.carpetEnd = 430;
  p.walls.push_back({{-21, 400}, {21, 400}, 0, 30, kBluePaint});
  VisionParams params;
  params.goal.maxLogOddsAgainst = 20;  // so narrow a one is unlikely
  const Seen seen = look(p, cameraAt(16, 0, 0), params);
  const auto* goal = find(seen.percepts, LandmarkKind::goalBlue);
  ASSERT_NE(goal, nullptr);
  EXPECT_TRUE(goal->leftEdgeCut && goal->rightEdgeCut);
  EXPECT_NEAR(goal->distance, 380, 20);
  EXPECT_NEAR(goal->heading.deg(), 0.0, 3.5);  // 19 cm of it may be hidden on either side
}

TEST(Goal, OnTheFloorBehindTheCarpetIsRefused) {
  Painting p;
  p.carpetEnd = 200;
  addGoal(p, 0, 230, kBluePaint);
  const Seen seen = look(p, cameraAt(24, 0, -3));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalAboveFieldEdge), 1);
}

TEST(Goal, HalfSizeBoxNearByIsRefusedByItsFoot) {
  Painting p;  // half as large and near, so that its size says 200 cm, its foot 90
  p.walls.push_back({{-20, 100}, {20, 100}, 0, 15, kBluePaint});
  const Seen seen = look(p, cameraAt(24, 0, -6));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalNoHeight), 1);
}

TEST(Goal, BlueWallThatLeavesTheImageAtTheTopIsRefused) {
  Painting p;
  p.walls.push_back({{-40, 250}, {40, 250}, 0, 200, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, -5));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalAspect), 1);
}

// The goal shows its width, a box of the other colour beside it half of that.
TEST(Goal, OfBothColoursTheLikelierIsKept) {
  Painting p = goalAt(0, 300, kBluePaint);
  p.walls.push_back({{110, 330}, {150, 330}, 0.0, 30.0, kYellowPaint});
  const Seen seen = look(p, cameraAt(16, -10, -4));
  EXPECT_NE(find(seen.percepts, LandmarkKind::goalBlue), nullptr);
  EXPECT_EQ(find(seen.percepts, LandmarkKind::goalYellow), nullptr);
  EXPECT_EQ(seen.percepts.landmarks.size(), 1U);
}

TEST(Goal, FarPatchOfAFewPixelsIsRefused) {
  Painting p;
  p.walls.push_back({{-8, 500}, {8, 500}, 0, 10, kYellowPaint});
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::goalTooSmall), 1);
}

TEST(GoalChecks, ShapeAndDistanceDecideAtTheirLimits) {
  const GoalFinderParams p;
  GoalCandidate c;
  c.box = {50, 50, 90, 65};
  EXPECT_TRUE(goalHasShape(c, p));
  c.box.bottom = 52 + 40 * p.maxTall;
  EXPECT_FALSE(goalHasShape(c, p));
  c.left.cut = true;
  EXPECT_TRUE(goalHasShape(c, p));
  c.box = {10, 50, 190, 49 + 180 / p.maxFlat};
  EXPECT_FALSE(goalHasShape(c, p));
  EXPECT_FALSE(goalIsMeasured(c));
  c.wallDistance = 559;
  EXPECT_TRUE(goalIsMeasured(c));
  EXPECT_TRUE(goalIsNear(c, p));
  c.wallDistance = 561;
  EXPECT_FALSE(goalIsNear(c, p));
}

TEST(GoalChecks, MostColumnsTallIsNoGoal) {
  GoalCandidate c;
  c.box = {50, 50, 90, 65};
  GoalColumn chosen;
  chosen.chosen = true;
  GoalColumn tall;
  tall.tall = true;
  for (int i = 0; i < 4; ++i) c.columns.push_back(chosen);
  for (int i = 0; i < 6; ++i) c.columns.push_back(tall);
  EXPECT_TRUE(goalHasShape(c, {}));
  c.columns.push_back(tall);
  EXPECT_FALSE(goalHasShape(c, {}));
}

// Ends `width` cm apart, both 200 cm from the camera: the mouth is 30 cm before a wall at 230.
GoalCandidate wide(const CameraPose& camera, double width) {
  GoalCandidate c;
  c.wallDistance = 230.0;
  const double y = camera.position.y + std::sqrt(200.0 * 200.0 - 0.25 * width * width);
  c.left.point = *body::project(camera, {-0.5 * width, y, 15.0});
  c.right.point = *body::project(camera, {0.5 * width, y, 15.0});
  return c;
}

TEST(GoalChecks, WidthBetweenItsEndsIsThatOfAMouth) {
  const Board board(cameraAt(16, 0, 0));
  const GoalFinderParams p;
  const auto kept = [&](double width) {
    return goalHasWidth(board.scene(), wide(board.body.camera, width), p);
  };
  EXPECT_FALSE(kept(p.minVisibleWidth - 2.0));
  EXPECT_TRUE(kept(p.minVisibleWidth + 2.0));
  EXPECT_TRUE(kept(p.maxVisibleWidth - 2.0));
  EXPECT_FALSE(kept(p.maxVisibleWidth + 2.0));
}

TEST(GoalChecks, NarrowOneWhoseFootFitsMayBePartOfAGoal) {
  const Board board(cameraAt(16, 0, 0));
  const GoalFinderParams p;
  GoalCandidate c = wide(board.body.camera, p.maxPartWidth - 2.0);
  EXPECT_TRUE(goalIsPart(board.scene(), c, p));
  c.footError = Angle::deg(1).rad();
  EXPECT_FALSE(goalIsPart(board.scene(), c, p));
  EXPECT_FALSE(goalIsPart(board.scene(), wide(board.body.camera, p.maxPartWidth + 2.0), p));
}

GoalFacts factsOfAWholeGoal() {
  GoalFacts facts;
  facts.wallDistance = 300;
  facts.visibleWidth = 79;
  facts.width = 50;
  facts.lowestFoot = 0.4;
  facts.meanFoot = 0.1;
  facts.misfit = 0.05;
  facts.footError = 0.1;
  facts.measured = 20;
  facts.chosen = 22;
  facts.coloured = 0.9;
  facts.green = 0.95;
  facts.lateralOffset = 60;
  facts.edgeLateralOffset = 60;
  facts.edgeTurn = 4;
  return facts;
}

TEST(GoalFacts, OneWeakFactDoesNotMakeAWholeGoalUnlikely) {
  const GoalFinderParams p;
  const GoalFacts whole = factsOfAWholeGoal();
  EXPECT_LE(logOddsAgainst(whole), p.maxLogOddsAgainst);
  GoalFacts high = whole;
  high.lowestFoot = -0.3;
  GoalFacts narrow = whole;
  narrow.visibleWidth = 45;
  GoalFacts few = whole;
  few.measured = 4;
  for (const GoalFacts& facts : {high, narrow, few}) {
    EXPECT_GT(logOddsAgainst(facts), logOddsAgainst(whole));
    EXPECT_LE(logOddsAgainst(facts), p.maxLogOddsAgainst);
  }
}

TEST(GoalFacts, SeveralWeakFactsDo) {
  GoalFacts facts = factsOfAWholeGoal();
  facts.lowestFoot = -0.6;
  facts.visibleWidth = 30;
  facts.measured = 4;
  facts.footError = 0.6;
  EXPECT_GT(logOddsAgainst(facts), GoalFinderParams{}.maxLogOddsAgainst);
}

TEST(GoalFacts, PaintTellsOnlyWhereItIsPalerThanAGoals) {
  GoalFacts facts = factsOfAWholeGoal();
  const double whole = logOddsAgainst(facts);
  facts.paint = 0.92;
  EXPECT_DOUBLE_EQ(logOddsAgainst(facts), whole);
  facts.paint = 0.84;
  EXPECT_GT(logOddsAgainst(facts), whole + 4.0);
}

TEST(GoalFacts, ASingleMeasuredColumnSpeaksAgainstAGoalMoreThanTwo) {
  GoalFacts facts = factsOfAWholeGoal();
  facts.measured = 2;
  const double two = logOddsAgainst(facts);
  facts.measured = 1;
  EXPECT_GT(logOddsAgainst(facts), two + 1.5);
}

TEST(GoalFacts, AGoalFarFromItsPlaceIsUnlikely) {
  const GoalFacts whole = factsOfAWholeGoal();
  GoalFacts atACorner = whole;
  atACorner.cornerError = 150;
  GoalFacts atABeacon = whole;
  atABeacon.beaconError = 200;
  GoalFacts beyondTheEdge = whole;
  beyondTheEdge.edgeDistance = -150;
  for (const GoalFacts& facts : {atACorner, atABeacon, beyondTheEdge})
    EXPECT_GT(logOddsAgainst(facts), logOddsAgainst(whole) + 1.0);
}

TEST(GoalFacts, FactsAreCountedOverTheChosenColumns) {
  Board board(cameraAt(16, 0, 0));
  board.edges.push_back({100, 100, 20, 0.5});
  GoalCandidate c = wide(board.body.camera, 60);
  for (const double foot : {99.0, 102.0, 120.0}) {
    GoalColumn column;
    column.chosen = foot < 110.0;
    column.distance = foot < 100.0 ? 230.0 : 0.0;
    column.foot = {100, foot};
    c.columns.push_back(column);
  }
  c.footError = Angle::deg(-0.5).rad();
  const GoalFacts facts = goalFacts(board.scene(), c, {true, {0, 200}, 0.0, 3.0});
  EXPECT_NEAR(facts.visibleWidth, 60, 0.5);
  EXPECT_NEAR(facts.lowestFoot, 2.0, 1e-9);
  EXPECT_NEAR(facts.meanFoot, 0.5, 1e-9);
  EXPECT_EQ(facts.measured, 1.0);
  EXPECT_EQ(facts.chosen, 2.0);
  EXPECT_EQ(facts.misfit, 3.0);
  EXPECT_NEAR(facts.footError, 0.5, 1e-9);
  EXPECT_NEAR(facts.lateralOffset, 0.0, 1e-9);
  c.left.hidden = true;
  const GoalFacts oblique = goalFacts(board.scene(), c, {true, {0, 200}, -0.5, 3.0});
  EXPECT_EQ(oblique.hidden, 1.0);
  EXPECT_NEAR(oblique.lateralOffset, 200.0 * std::sin(0.5), 1e-6);
}

TEST(GoalChecks, LittleOfAGoalMustStandInsideTheFieldEdge) {
  Board board(cameraAt(16, 0, 0));
  board.edges.push_back({100, 100, 20, 0.5});
  const GoalFinderParams p;
  GoalCandidate c = wide(board.body.camera, p.maxPartWidth - 2.0);
  c.columns.push_back({});
  c.columns[0].chosen = true;
  c.columns[0].foot = {100, 100.5 - p.minPartBelowFieldEdge};
  EXPECT_TRUE(goalIsPart(board.scene(), c, p));
  c.columns[0].foot.y = 99.5 + p.minPartBelowFieldEdge;
  EXPECT_FALSE(goalIsPart(board.scene(), c, p));
}

TEST(GoalChecks, BetweenTwoRobotsAndAtAnImageBorderLessOfItNeedsToShow) {
  const Board board(cameraAt(16, 0, 0));
  const GoalFinderParams p;
  const auto kept = [&](double width, bool cut, bool hidden) {
    GoalCandidate c = wide(board.body.camera, width);
    c.left.cut = cut;
    c.left.hidden = c.right.hidden = hidden;
    return goalHasWidth(board.scene(), c, p);
  };
  EXPECT_FALSE(kept(p.minCutWidth + 1.0, false, false));
  EXPECT_TRUE(kept(p.minCutWidth + 1.0, true, false));
  EXPECT_FALSE(kept(p.minHiddenWidth + 1.0, true, false));
  EXPECT_TRUE(kept(p.minHiddenWidth + 1.0, false, true));
  EXPECT_FALSE(kept(p.minHiddenWidth - 1.0, false, true));
}

TEST(GoalChecks, MouthFacesTheFieldUpToItsLargestTurn) {
  const GoalFinderParams p;
  const auto kept = [&p](double turnDegrees, bool valid = true) {
    return goalFacesField({valid, {0, 250}, turnDegrees / kDegrees, 0.0}, p);
  };
  const double max = p.maxTurn.deg();
  EXPECT_TRUE(kept(max - 1));
  EXPECT_TRUE(kept(1 - max));
  EXPECT_FALSE(kept(max + 1));
  EXPECT_FALSE(kept(-1 - max));
  EXPECT_FALSE(kept(0, false));
  // Seen 45 deg to the right, square to the sight is a turn of -45.
  EXPECT_TRUE(goalFacesField({true, {200, 200}, -110 / kDegrees, 0.0}, p));
  EXPECT_FALSE(goalFacesField({true, {200, 200}, 50 / kDegrees, 0.0}, p));
}

}  // namespace
}  // namespace kelpie::vision
