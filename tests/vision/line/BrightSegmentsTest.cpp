// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "tests/vision/Board.h"
#include "vision/line/BrightSegments.h"

namespace kelpie::vision {
namespace {

constexpr Paint kThirdOfWhite{114, 110, 108};

TEST(BrightSegments, SegmentLiesBetweenItsTwoEdges) {
  Board board;
  board.fill(0, 90, kImageWidth, 96, kWhitePaint);
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  const auto found = brightSegments(board.sampler, gridLine, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(gridLine.at(found[0].middle()).y, 93.0, 0.01);
  EXPECT_NEAR(found[0].paint, 6.0, 0.05);
  EXPECT_NEAR(gridLine.row(found[0].first), 96.5, 0.5);  // carpet, at most one pixel away
  EXPECT_NEAR(gridLine.row(found[0].last), 88.5, 0.5);
}

TEST(BrightSegments, LineThinnerThanAPixelHasItsTrueWidth) {
  Board board;
  board.fill(120, 0, 121, kImageHeight, kThirdOfWhite);
  const GridLine gridLine = gridLineRight(84);
  const auto found = brightSegments(board.sampler, gridLine, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(gridLine.at(found[0].middle()).x, 120.5, 0.01);
  EXPECT_NEAR(found[0].paint, 0.34, 0.02);
}

TEST(BrightSegments, EveryLineAcrossAGridLineIsFound) {
  Board board;
  for (const int x : {20, 60, 63, 150}) board.fill(x, 0, x + 2, kImageHeight, kWhitePaint);
  EXPECT_EQ(brightSegments(board.sampler, gridLineRight(84), {}).size(), 4U);
}

TEST(BrightSegments, WhiteLongerThanTheLongestIsNoSegment) {
  Board board;
  board.fill(50, 0, 112, kImageHeight, kWhitePaint);
  EXPECT_TRUE(brightSegments(board.sampler, gridLineRight(84), {}).empty());
}

TEST(BrightSegments, ThickDiagonalGoesOnBesideTheGridLine) {
  Board board;
  for (int x = 40; x < 160; ++x) board.fill(x, x - 20, x + 1, x - 14, kWhitePaint);
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  const auto found = brightSegments(board.sampler, gridLine, {});
  ASSERT_EQ(found.size(), 1U);
  const auto beside = segmentBeside(board.sampler, gridLine, found[0], 3);
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->middle(), found[0].middle() - 3.0, 0.01);  // downwards, against the grid line
}

TEST(BrightSegments, SingleWhitePixelEndsBesideTheGridLine) {
  Board board;
  board.fill(104, 90, 105, 91, kWhitePaint);
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  const auto found = brightSegments(board.sampler, gridLine, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(segmentBeside(board.sampler, gridLine, found[0], 3));
}

TEST(BrightSegments, FootOfWhiteThatDoesNotEndIsARisingEdge) {
  Board board;
  board.fill(0, 0, kImageWidth, 70, kWhitePaint);
  const GridLine gridLine = gridLineUp(104, kUsableTop);
  const auto edges = risingEdges(board.sampler, gridLine, {});
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(gridLine.at(edges[0].foot).y, 70.0, 0.01);
  EXPECT_NEAR(*edgeBeside(board.sampler, gridLine, edges[0], 6), edges[0].foot, 0.01);
}

// Beside the bright pixels may lie a half bright one, brighter than half-way: then the edge is
// there and not where a line through two nearly equal pixels reaches half-way, far outside the
// image.
TEST(BrightSegments, EdgesStayBetweenTheCarpetOnBothSides) {
  Random random(7205);
  Board board;
  int segments = 0;
  for (int plane = 0; plane < 300; ++plane) {
    for (int x = 0; x < kImageWidth; ++x) {
      const double grey = 60.0 + random.index(3) * 45.0 + random.index(6);
      board.fill(x, 84, x + 1, 85, {grey, 110, 110});
    }
    const GridLine gridLine = gridLineRight(84);
    for (const BrightSegment& s : brightSegments(board.sampler, gridLine, {})) {
      ++segments;
      EXPECT_GE(s.from, s.first);
      EXPECT_LE(s.from, s.last);
      EXPECT_GE(s.to, s.first);
      EXPECT_LE(s.to, s.last);
    }
    for (const RisingEdge& r : risingEdges(board.sampler, gridLine, {})) {
      EXPECT_GE(r.foot, r.first);
      EXPECT_LE(r.foot, r.last + 1);
    }
  }
  EXPECT_GT(segments, 1000);
}

}  // namespace
}  // namespace kelpie::vision
