// SPDX-License-Identifier: Apache-2.0
// What experiments of skills find in a match of which all is known: frames of 1/30 s, made by hand.
#include <gtest/gtest.h>

#include "tests/experiments/MadeMatch.h"
#include "tools/experiments/skills/Judges.h"

namespace kelpie::experiments {
namespace {

// The goal's middle is 192 cm straight up the field from the ball, its posts 40 cm to each side: at
// 11.8 deg.
Aimed shotAt(double deg, bool held) {
  MadeMatch match;
  match.robot.position = {180.0, 340.0};
  match.ball = {180.0, held ? 348.0 : 360.0};
  match.rolls(30, {});
  match.rolls(30, deg, 150.0);
  return aimedIn(match.played);
}

TEST(Aimed, TheErrorIsTheAngleToTheGoalsMiddleLeftPositive) {
  const Aimed left = shotAt(100.0, true);
  EXPECT_TRUE(left.shot);
  EXPECT_TRUE(left.onTarget);
  // The first frame's way of 5 cm brings the ball 10.3 deg from the middle.
  EXPECT_NEAR(left.errorDeg, 10.0, 0.4);
  EXPECT_NEAR(shotAt(85.0, true).errorDeg, -5.0, 0.4);
  EXPECT_NEAR(shotAt(90.0, true).errorDeg, 0.0, 1e-6);
}

TEST(Aimed, BesideThePostsOrDownTheFieldIsOffTarget) {
  EXPECT_TRUE(shotAt(90.0 + 11.0, true).onTarget);
  EXPECT_FALSE(shotAt(90.0 + 13.0, true).onTarget);
  EXPECT_FALSE(shotAt(90.0 - 13.0, true).onTarget);
  EXPECT_FALSE(shotAt(-90.0, true).onTarget);
}

TEST(Aimed, AKickOfAFreeBallIsNotAimed) { EXPECT_FALSE(shotAt(90.0, false).shot); }

// The opponent stands 30 cm beyond the ball on its way to the goal; past it is from y = 360 on.
MadeMatch beforeAnOpponent() {
  MadeMatch match;
  match.opponent = Pose2{{180.0, 320.0}, Angle::deg(-90.0)};
  match.rolls(10, {});
  return match;
}

TEST(Dodged, AShotThatComes40CentimetresPastTheOpponentHasPassed) {
  MadeMatch match = beforeAnOpponent();
  match.rolls(18, {0.0, 150.0});  // 90 cm, to y = 380
  match.rolls(90, {});
  const Dodged dodged = dodgedIn(match.played, 25.0);
  EXPECT_TRUE(dodged.passed);
  EXPECT_EQ(dodged.shots.hits, 1);
  EXPECT_EQ(dodged.shots.all, 1);
}

TEST(Dodged, AShotThatEndsAtTheOpponentHasNot) {
  MadeMatch match = beforeAnOpponent();
  match.rolls(12, {0.0, 150.0});  // 60 cm, to y = 350
  match.rolls(90, {});
  const Dodged dodged = dodgedIn(match.played, 25.0);
  EXPECT_FALSE(dodged.passed);
  EXPECT_EQ(dodged.shots.hits, 0);
  EXPECT_EQ(dodged.shots.all, 1);
}

TEST(Dodged, WhatIsPutBackBeyondTheOpponentHasNotPassed) {
  MadeMatch match = beforeAnOpponent();
  match.happens(sim::EventKind::out);
  match.ball = {40.0, 440.0};
  match.rolls(30, {});
  EXPECT_FALSE(dodgedIn(match.played, 25.0).passed);
}

// Seen or not until the throw at 4 s, then unseen for so many frames, then seen.
Searched searchedWith(bool before, int unseen, int seen) {
  MadeMatch match;
  match.ball = {180.0, 440.0};
  match.seesBall = before;
  match.rolls(120, {});
  match.seesBall = false;
  match.rolls(unseen, {});
  match.seesBall = true;
  match.rolls(seen, {});
  match.seesBall = false;
  match.rolls(30, {});
  return searchedIn(match.played, 4.0, 12.0);
}

TEST(Searched, IsTheTimeFromTheThrowUntilTheBallIsSeen) {
  const Searched searched = searchedWith(true, 90, 10);
  EXPECT_TRUE(searched.watched);
  EXPECT_TRUE(searched.lost);
  EXPECT_NEAR(searched.seconds, 3.0, 1.1 / 30.0);
}

TEST(Searched, ABallSeenInOneImageAloneOrNeverTakesTheLimit) {
  EXPECT_EQ(searchedWith(true, 90, 1).seconds, 12.0);
  EXPECT_EQ(searchedWith(true, 90, 0).seconds, 12.0);
}

TEST(Searched, ABallThatStaysInSightIsNotLost) { EXPECT_FALSE(searchedWith(true, 0, 60).lost); }

TEST(Searched, WhoDidNotSeeItBeforeWasNotWatching) {
  EXPECT_FALSE(searchedWith(false, 90, 10).watched);
}

TEST(Searched, SomethingElseInItsPlaceIsNotTheBall) {
  MadeMatch match;
  match.ball = {180.0, 440.0};
  match.seesBall = true;
  match.rolls(120, {});
  match.rolls(120, {});
  for (std::size_t i = 120; i < 240; ++i) match.played.moments[i].ball.heading = Angle::deg(30.0);
  EXPECT_EQ(searchedIn(match.played, 4.0, 12.0).seconds, 12.0);
}

// The box of the far goal: 65 cm deep from y = 540, 130 wide about x = 180.
TEST(Kept, AKeeperIsOutsideBeyondItsBoxOnly) {
  MadeMatch match;
  match.opponent = Pose2{{180.0, 480.0}, Angle::deg(-90.0)};
  match.rolls(6, {});
  match.opponent->position = {180.0, 470.0};
  match.rolls(1, {});
  match.opponent->position = {110.0, 500.0};
  match.rolls(1, {});
  match.opponent->position = {244.0, 539.0};
  match.rolls(2, {});
  const Kept kept = keptIn(match.played, false);
  EXPECT_EQ(kept.outside.hits, 2);
  EXPECT_EQ(kept.outside.all, 10);
}

// The ball lies 20 cm before the keeper and then rolls into the goal.
bool setOff(Point2<Field> attacker, bool scored) {
  MadeMatch match;
  match.robot.position = attacker;
  match.opponent = Pose2{{180.0, 520.0}, Angle::deg(-90.0)};
  match.ball = {180.0, 500.0};
  match.rolls(10, {});
  match.rolls(20, {0.0, 80.0});
  return keptIn(match.played, scored).setOff;
}

TEST(Kept, AnOwnGoalIsOneThatNobodyElseWasNear) {
  EXPECT_TRUE(setOff({180.0, 300.0}, true));
  EXPECT_FALSE(setOff({180.0, 470.0}, true)) << "30 cm from the ball";
  EXPECT_FALSE(setOff({180.0, 300.0}, false)) << "no goal";
}

Grabbed carried(int frames, double forward, double turn, bool released = true) {
  MadeMatch match;
  match.carries(frames, forward, turn);
  if (released) match.rolls(20, 90.0, 200.0);
  return grabbedIn(match.played);
}

TEST(Grabbed, ABallCarriedForASecondAndKickedIsASuccess) {
  const Grabbed ahead = carried(31, 20.0, 0.0);
  EXPECT_TRUE(ahead.kept);
  EXPECT_TRUE(ahead.success);
  ASSERT_EQ(ahead.holds.size(), 1U);
  EXPECT_NEAR(ahead.holds[0], 1.0, 1e-3);
  EXPECT_EQ(ahead.tooLong + ahead.tooFar, 0);
  EXPECT_TRUE(carried(31, 0.0, 90.0).success) << "turned";
}

TEST(Grabbed, ABallThatIsOnlyStoodOverOrNotLetGoIsNone) {
  EXPECT_FALSE(carried(31, 2.0, 5.0).success);
  EXPECT_TRUE(carried(31, 2.0, 5.0).kept);
  EXPECT_FALSE(carried(10, 20.0, 0.0).kept) << "0.3 s";
  EXPECT_FALSE(carried(31, 20.0, 0.0, false).success);
}

TEST(Grabbed, TheRulesAllow3SecondsAnd50Centimetres) {
  EXPECT_EQ(carried(89, 40.0, 0.0).tooLong, 0);
  const Grabbed tooLong = carried(95, 40.0, 0.0);
  EXPECT_EQ(tooLong.tooLong, 1);
  EXPECT_EQ(tooLong.tooFar, 0);
  EXPECT_FALSE(tooLong.success);
  const Grabbed tooFar = carried(61, 55.0, 0.0);
  EXPECT_EQ(tooFar.tooLong, 0);
  EXPECT_EQ(tooFar.tooFar, 1);
  EXPECT_FALSE(tooFar.success);
}

TEST(Grabbed, AGrabHasTheFramesInWhichItsMotionRan) {
  MadeMatch match;
  for (const auto& [motion, frames] :
       {std::pair{MotionKind::grab, 12}, std::pair{MotionKind::none, 5},
        std::pair{MotionKind::grabQuick, 6}, std::pair{MotionKind::none, 5},
        std::pair{MotionKind::grab, 13}, std::pair{MotionKind::none, 1},
        std::pair{MotionKind::grab, 4}}) {
    match.motion = motion;
    match.rolls(frames, {});
  }
  const Grabbed grabbed = grabbedIn(match.played);
  EXPECT_EQ(grabbed.grabs, (Values{12.0, 13.0})) << "the end cuts the last one off";
  EXPECT_EQ(grabbed.quickGrabs, Values{6.0});
}

// From 2.5 s on the ball rolls from the left to the right, `ahead` cm in front of the robot; it is
// in its reach, 8 cm to each side, after 102 of 110 cm.
MadeMatch rolledPast(double ahead) {
  MadeMatch match;
  match.ball = {70.0, 270.0 + ahead};
  match.rolls(75, {});
  match.rolls(45, {90.0, 0.0});
  return match;
}

TEST(Met, ABallIsReachedWhenItIsBeforeTheChest) {
  const Met met = metIn(rolledPast(10.0).played, 2.5, 6.0);
  EXPECT_TRUE(met.reached);
  EXPECT_TRUE(met.kept);
  EXPECT_NEAR(met.seconds, 102.0 / 90.0, 1.5 / 30.0);
}

TEST(Met, ABallThatPassesBeyondItsReachOrBehindItIsNot) {
  for (const double ahead : {16.0, -1.0}) {
    const Met met = metIn(rolledPast(ahead).played, 2.5, 6.0);
    EXPECT_FALSE(met.reached);
    EXPECT_EQ(met.seconds, 6.0);
  }
}

TEST(Met, ABallThatIsOutBeforeIsNeitherReachedNorKept) {
  MadeMatch match;
  match.ball = {70.0, 280.0};
  match.rolls(90, {});
  match.happens(sim::EventKind::out);
  match.ball = {180.0, 280.0};
  match.rolls(30, {});
  const Met met = metIn(match.played, 2.5, 6.0);
  EXPECT_FALSE(met.reached);
  EXPECT_FALSE(met.kept);
}

}  // namespace
}  // namespace kelpie::experiments
