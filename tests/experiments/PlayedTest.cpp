// SPDX-License-Identifier: Apache-2.0
// What experiments make of a match's true places: holds, shots, a ball that leaves.
#include <gtest/gtest.h>

#include "tests/experiments/MadeMatch.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

TEST(Played, ARobotIsFoundByItsTeam) {
  PlayedMoment moment;
  moment.truth.robots.push_back({TeamColour::red, 1, {{1.0, 2.0}, {}}, {}});
  moment.truth.robots.push_back({TeamColour::blue, 1, {{3.0, 4.0}, {}}, {}});
  EXPECT_EQ(moment.robot(TeamColour::blue).position.x, 3.0);
  EXPECT_EQ(moment.robot(TeamColour::red).position.x, 1.0);
}

TEST(Played, AShotHasItsDirectionAndIsOneShot) {
  MadeMatch match;
  match.rolls(10, {});
  match.rolls(20, {100.0, 100.0});
  match.rolls(20, {});
  const auto shots = shotsOf(match.played, TeamColour::red);
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_NEAR(shots[0].direction.deg(), 45.0, 1e-6);
  EXPECT_NEAR(shots[0].speed, 141.4, 0.1);
  EXPECT_EQ(shots[0].moment, 10U);
}

TEST(Played, ASlowBallAndABallFarFromTheRobotAreNoShots) {
  MadeMatch slow;
  slow.rolls(10, {});
  slow.rolls(20, {0.0, 55.0});
  EXPECT_TRUE(shotsOf(slow.played, TeamColour::red).empty());
  MadeMatch far;
  far.ball.y = 320.0;
  far.rolls(10, {});
  far.rolls(20, {0.0, 100.0});
  EXPECT_TRUE(shotsOf(far.played, TeamColour::red).empty());
}

TEST(Played, AHoldIsOfTheRobotsTeam) {
  MadeMatch match;
  match.ball.y = 278.0;
  match.rolls(30, {});
  EXPECT_EQ(holdsOf(match.played, TeamColour::red).size(), 1U);
}

TEST(Played, ABallIsOutAtTheFirstOutOrGoalFromThenOn) {
  Played played;
  for (const double seconds : {1.0, 3.0}) {
    sim::MatchEvent event;
    event.time = {static_cast<std::int64_t>(1e6 * seconds)};
    event.kind = seconds == 1.0 ? sim::EventKind::out : sim::EventKind::goal;
    played.events.push_back(event);
  }
  EXPECT_EQ(played.outAfter(0.0), 1.0);
  EXPECT_EQ(played.outAfter(1.5), 3.0);
  EXPECT_FALSE(played.outAfter(3.5));
}

TEST(Played, ABallIsRightlySeenWithinTenDegreesAndAThirdOfItsDistance) {
  const Pose2 robot{{180.0, 270.0}, Angle::deg(90.0)};
  const Point2<Field> ball{180.0, 420.0};
  BallPercept seen;
  EXPECT_FALSE(isBall(seen, robot, ball));
  seen.present = true;
  seen.distance = 130.0;
  seen.heading = Angle::deg(9.0);
  EXPECT_TRUE(isBall(seen, robot, ball));
  seen.heading = Angle::deg(11.0);
  EXPECT_FALSE(isBall(seen, robot, ball));
  seen.heading = {};
  seen.distance = 90.0;
  EXPECT_FALSE(isBall(seen, robot, ball));
}

TEST(Tries, AShotCrossesTheGoalLineWhereItsDirectionSays) {
  Shot shot;
  shot.from = {100.0, 500.0};
  shot.direction = Angle::deg(45.0);
  EXPECT_NEAR(*crossing(shot, 540.0), 140.0, 1e-9);
  shot.direction = Angle::deg(-45.0);
  EXPECT_FALSE(crossing(shot, 540.0));
}

TEST(Tries, EveryWayIsPlayedByTheSameDraws) {
  EXPECT_EQ(drawsOf({0, {3, 17}}).next(), drawsOf({1, {3, 17}}).next());
  EXPECT_NE(drawsOf({0, {3, 17}}).next(), drawsOf({0, {4, 18}}).next());
}

}  // namespace
}  // namespace kelpie::experiments
