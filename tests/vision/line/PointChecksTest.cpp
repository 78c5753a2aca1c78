// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Camera.h"
#include "tests/vision/Board.h"
#include "vision/line/PointChecks.h"

namespace kelpie::vision {
namespace {

// The camera looks 30 deg down from 16 cm: row 100 is at 24 cm.
LineCandidate candidate(const Board& board, const GridLine& gridLine) {
  const auto found = brightSegments(board.sampler, gridLine, {});
  if (found.empty()) return {};
  return {gridLine, found[0], gridLine.at(found[0].middle())};
}

RisingEdge firstEdge(const Board& board, const GridLine& gridLine) {
  const auto edges = risingEdges(board.sampler, gridLine, {});
  return edges.empty() ? RisingEdge{} : edges[0];
}

TEST(PointChecks, HeadSlowerThanTheGateIsKept) {
  const LinePointParams p;
  BodyState body;
  body.headSpeed = Angle::deg(5.1).rad();
  EXPECT_TRUE(headIsSlow(body, p));
  body.headSpeed = Angle::deg(5.3).rad();
  EXPECT_FALSE(headIsSlow(body, p));
}

TEST(PointChecks, PointsLieBelowHorizonAndFieldEdge) {
  Board board;
  board.body.horizon = {40, 60};
  EXPECT_TRUE(pointIsBelowHorizon(board.scene(), {104, 51}));
  EXPECT_FALSE(pointIsBelowHorizon(board.scene(), {104, 49}));
  board.edges.push_back({70, 70});
  EXPECT_TRUE(pointIsBelowHorizon(board.scene(), {104, 71}));
  EXPECT_FALSE(pointIsBelowHorizon(board.scene(), {104, 69}));
}

TEST(PointChecks, CornersOfTheImageHoldNoPoints) {
  const LinePointParams p;  // thesis 2004 equation 3.1 with B = 10
  for (const double x : {4.0, kImageWidth - 4.0})
    for (const double y : {5.0, kImageHeight - 5.0}) EXPECT_FALSE(pointIsOutsideCorners({x, y}, p));
  EXPECT_TRUE(pointIsOutsideCorners({5, 5}, p));
  EXPECT_TRUE(pointIsOutsideCorners({204, 20}, p));
}

TEST(PointChecks, BoxesOfBallAndRobotsHoldNoPoints) {
  Percepts seen;
  seen.ball.centre = {50, 50};
  seen.ball.radius = 10;
  EXPECT_TRUE(pointIsOutsideObjects(seen, {50, 50}, {}));
  seen.ball.present = true;
  EXPECT_FALSE(pointIsOutsideObjects(seen, {58, 58}, {}));
  EXPECT_TRUE(pointIsOutsideObjects(seen, {63, 50}, {}));
  RobotPercept robot;
  robot.box = {100, 60, 140, 90};
  seen.robots.push_back(robot);
  EXPECT_FALSE(pointIsOutsideObjects(seen, {120, 75}, {}));
  EXPECT_TRUE(pointIsOutsideObjects(seen, {120, 93}, {}));
}

TEST(PointChecks, OneOddPixelBetweenGreenAndWhiteIsAllowed) {
  Board board;
  board.fill(0, 90, kImageWidth, 96, kWhitePaint);
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  EXPECT_TRUE(lineIsBetweenGreen(board.sampler, candidate(board, gridLine)));
  board.fill(0, 96, kImageWidth, 97, {60, 131, 122});
  EXPECT_TRUE(lineIsBetweenGreen(board.sampler, candidate(board, gridLine)));
  board.fill(0, 96, kImageWidth, 99, {60, 131, 122});
  EXPECT_FALSE(lineIsBetweenGreen(board.sampler, candidate(board, gridLine)));
}

TEST(PointChecks, OneGreenPixelIsNotCarpet) {
  Board board;
  board.fill(0, 90, kImageWidth, 96, kWhitePaint);
  board.fill(0, 86, kImageWidth, 89, {60, 131, 122});  // row 89 alone is green
  EXPECT_FALSE(lineIsBetweenGreen(board.sampler, candidate(board, gridLineUp(104, kUsableTop))));
}

TEST(PointChecks, YellowIsNoPaint) {
  for (const bool white : {true, false}) {
    Board board;
    board.fill(0, 90, kImageWidth, 96, white ? kWhitePaint : kYellowPaint);
    const auto c = candidate(board, gridLineUp(104, kUsableTop));
    EXPECT_EQ(lineIsColourless(board.sampler, c, {}), white);
  }
}

TEST(PointChecks, WidthOnTheGroundTellsLinesFromBroaderAndThinnerThings) {
  const LinePointParams p;  // 2.5 cm, 40 % and 0.6 px
  EXPECT_TRUE(lineIsNarrow({0.2, 3.5}, 2.5, p));
  EXPECT_FALSE(lineIsNarrow({0.2, 3.7}, 2.5, p));
  EXPECT_TRUE(lineIsNarrow({3.0, 5.2}, 2.5, p));  // far away a pixel is wider than a line
  EXPECT_FALSE(lineIsNarrow({3.0, 5.4}, 2.5, p));
  EXPECT_TRUE(lineIsWide({0.2, 1.5}, 2.5, p));
  EXPECT_FALSE(lineIsWide({0.2, 1.3}, 2.5, p));
}

// Distance on the ground of a pixel from the line through two others.
double distanceFrom(const CameraPose& camera, PixelPoint p, PixelPoint a, PixelPoint b) {
  const auto at = [&](PixelPoint q) { return *body::groundPoint(camera, q); };
  const Point2<Robot> along = at(b) - at(a);
  const Point2<Robot> to = at(p) - at(a);
  return std::fabs(along.x * to.y - along.y * to.x) / along.norm();
}

TEST(PointChecks, WidthIsMeasuredAcrossTheLine) {
  Board board;
  const double truth =
      distanceFrom(board.body.camera, {104.5, 92.25}, {84.5, 92.25}, {124.5, 112.25});
  for (int x = 20; x < 180; ++x) board.fill(x, 40 + x / 2, x + 1, 50 + x / 2, kWhitePaint);
  for (const GridLine& gridLine : {gridLineUp(104, kUsableTop), gridLineRight(94)}) {
    const auto c = candidate(board, gridLine);
    const auto left = segmentBeside(board.sampler, gridLine, c.segment, -3);
    const auto right = segmentBeside(board.sampler, gridLine, c.segment, 3);
    ASSERT_TRUE(left && right);
    const auto width = widthOnGround(board.body.camera, c, gridLine.at(left->middle(), -3),
                                     gridLine.at(right->middle(), 3));
    EXPECT_NEAR(width->paint, truth, 0.1 * truth);  // both scans see the same stripe
  }
}

TEST(PointChecks, GreenSoonAfterTheFootIsNoBorder) {
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  for (const int top : {40, 85}) {
    Board board;
    board.fill(0, top, kImageWidth, 100, kWhitePaint);
    const RisingEdge edge = firstEdge(board, gridLine);
    EXPECT_EQ(borderIsLong(board.scene(), gridLine, edge, {}), top == 40) << top;
  }
}

TEST(PointChecks, BorderIsTenCentimetresHigh) {
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  for (const int top : {10, 85}) {
    Board board;
    board.field = *body::fieldDescription("2004");
    board.fill(0, 0, kImageWidth, top, kWallPaint);
    board.fill(0, 0, kImageWidth, top, {60, 131, 122});
    board.fill(0, top, kImageWidth, 100, kWhitePaint);
    const RisingEdge edge = firstEdge(board, gridLine);
    EXPECT_TRUE(borderIsLong(board.scene(), gridLine, edge, {})) << top;
    EXPECT_EQ(borderIsHigh(board.scene(), gridLine, edge, {}), top == 10) << top;
  }
}

TEST(PointChecks, FootOfABorderGoesOnToBothSides) {
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  for (const int right : {kImageWidth, 107}) {  // a wall, and a leg
    Board board;
    board.fill(60, 0, right, 100, kWhitePaint);
    EXPECT_EQ(borderGoesOn(board.sampler, gridLine, firstEdge(board, gridLine), {}), right > 107)
        << right;
  }
}

TEST(PointChecks, CornerOfAGoalBoxAtTheRimIsNoBorder) {
  Board board(cameraAt(16, 0, -20));
  board.fill(100, 3, 108, 90, kWhitePaint);           // a line to the upper rim
  board.fill(100, 82, kImageWidth, 90, kWhitePaint);  // and one to the right
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  const RisingEdge edge = firstEdge(board, gridLine);
  EXPECT_FALSE(borderHasSide(board.scene(), {104, 156, 0, -1, 154}, {76, 78, 76.5, 130}, {}));
  EXPECT_TRUE(
      borderHasSide(board.scene(), gridLine, edge, {}));  // right of the corner all is white
}

TEST(PointChecks, FieldPointHasGreenToBothSides) {
  Board board;
  board.fill(110, 80, 112, 82, kWhitePaint);
  EXPECT_TRUE(fieldIsGreenBeside(board.sampler, {104.5, 80.5}, {}));
  board.fill(98, 80, 99, 82, kWhitePaint);
  EXPECT_FALSE(fieldIsGreenBeside(board.sampler, {104.5, 80.5}, {}));
}

TEST(PointChecks, ThinLineWithTheClassOfCarpetIsNoFieldPoint) {
  Board board;
  EXPECT_TRUE(fieldIsEven(board.sampler, {104.5, 80.5}, {}));
  board.fill(0, 80, kImageWidth, 81, {107, 109, 106});
  EXPECT_FALSE(fieldIsEven(board.sampler, {104.5, 80.5}, {}));
}

}  // namespace
}  // namespace kelpie::vision
