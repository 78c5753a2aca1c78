// SPDX-License-Identifier: Apache-2.0
// The compiled kick map against rows of pycode/data/kick_map.py.
#include <gtest/gtest.h>

#include "tools/sim/kicks/KickTable.h"

namespace kelpie::sim {
namespace {

TEST(KickTable, OfTheMapThatIsCompiledInCanBeRead) {
  const auto map = readKickMap(standardKickMapText());
  ASSERT_TRUE(map.ok()) << map.error();
}

TEST(KickTable, AtAPlaceOfTheMapSaysWhatTheMapSays) {
  const auto cell = freeKick(MotionKind::upennLeft, false, {4.0, 14.0});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(100.0 * cell->went, 100.0, 1e-9);
  EXPECT_NEAR(cell->direction.deg(), 44.0, 1e-9);
  EXPECT_NEAR(cell->distance, 220.0, 1e-9);
}

// A centimetre to the left and right of there 187 and 214 cm, nearer and further 206 and 206:
// balls anywhere between spread by 7.8 and 0 cm by that alone, of 26.
TEST(KickTable, HasNoSpreadOfPlacesForABallWhosePlaceIsKnown) {
  const auto cell = freeKick(MotionKind::upennLeft, false, {2.0, 14.0});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(cell->distanceSd, 24.8, 0.1);
}

// There places alone spread the ball by 4.6 of the 5 deg.
TEST(KickTable, LeavesHalfOfASpread) {
  const auto cell = freeKick(MotionKind::upennLeft, false, {4.0, 14.0});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(cell->directionSd.deg(), 2.5, 1e-9);
}

TEST(KickTable, OfAWalkingRobotIsAnother) {
  const auto cell = freeKick(MotionKind::upennLeft, true, {4.0, 14.0});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(cell->distance, 173.0, 1e-9);
}

TEST(KickTable, OfTheOtherSideIsMirrored) {
  const auto left = freeKick(MotionKind::upennLeft, false, {3.0, 13.0});
  const auto right = freeKick(MotionKind::upennRight, false, {-3.0, 13.0});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->direction.deg(), -right->direction.deg(), 1e-9);
  EXPECT_NEAR(left->distance, right->distance, 1e-9);
  const auto ahead = freeKick(MotionKind::kickForward, false, {2.0, 14.0});
  const auto mirrored = freeKick(MotionKind::kickForward, false, {-2.0, 14.0});
  ASSERT_TRUE(ahead && mirrored);
  EXPECT_NEAR(ahead->direction.deg(), -9.0, 1e-9);
  EXPECT_NEAR(mirrored->direction.deg(), 9.0, 1e-9);
}

// Half way between a place of 100 % and one of 33 %.
TEST(KickTable, BetweenPlacesCountsEachByTheBallsThatWent) {
  const auto cell = freeKick(MotionKind::kickForward, false, {5.0, 14.0});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(100.0 * cell->went, 66.5, 1e-9);
  EXPECT_NEAR(cell->distance, (100.0 * 106.0 + 33.0 * 47.0) / 133.0, 1e-9);
}

TEST(KickTable, AStepBeyondTheMapNoBallGoes) {
  const auto half = freeKick(MotionKind::upennLeft, false, {0.0, 19.0});
  const auto none = freeKick(MotionKind::upennLeft, false, {0.0, 20.0});
  ASSERT_TRUE(half && none);
  EXPECT_NEAR(100.0 * half->went, 48.0, 1e-9);
  EXPECT_DOUBLE_EQ(none->went, 0.0);
}

TEST(KickTable, KnowsKicksFromTheHoldAndNoneThatIsNotOne) {
  const auto held = heldKick(MotionKind::headSwipeRight);
  ASSERT_TRUE(held);
  EXPECT_NEAR(held->direction.deg(), -73.0, 1e-9);
  EXPECT_FALSE(heldKick(MotionKind::kickForward));
  EXPECT_FALSE(freeKick(MotionKind::hardForward, false, {0.0, 12.0}));
}

}  // namespace
}  // namespace kelpie::sim
