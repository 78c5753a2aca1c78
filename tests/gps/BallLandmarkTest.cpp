// SPDX-License-Identifier: Apache-2.0
// A mate's ball as a landmark of this robot's pose.
#include <gtest/gtest.h>

#include "gps/OnField.h"
#include "gps/ball/BallModels.h"
#include "gps/players/BallLandmark.h"

namespace kelpie::gps {
namespace {

// A robot that looks up-field from (180, 100), not sure of its place, and a ball 20 cm ahead of it.
struct Scrum {
  body::FieldDescription field;
  PlayersParams params;
  BallFilterParams ballParams;
  BallTrack ball;
  PlayersState players;
  Modes modes;

  Scrum() {
    beginModels({Vector2(0.0, 20.0), 1.0 * Matrix2::Identity()}, 1.0, 0.9, ball);
    PoseMode mode;
    mode.weight = 1.0;
    mode.pose = {{180, 100}, Angle::deg(90)};
    mode.covariance = {400, 0, 0, 0, 400, 0, 0, 0, 0.01};
    modes.push_back(mode);
  }
  // A message of player 2: the ball lies there, of that variance.
  void hear(std::uint16_t number, Point2<Field> at, double variance) {
    Teammate& mate = players.mates[1];
    mate.present = true;
    mate.last.player = 2;
    mate.last.number = number;
    mate.last.note.role = Role::defender;
    mate.last.ball = {true, at, {}, {variance, 0, 0, variance}, 0.0};
  }
  bool correct() { return correctByBall(ball, {field, params, ballParams}, players, modes); }
  double ballVariance() const {
    const Place place = placeOnField(modes[0], {0.0, 20.0}, Matrix2::Identity());
    return 0.5 * place.covariance.trace();
  }
};

TEST(BallLandmark, PutsARobotRightThatAMateKnowsTheBallBetterThan) {
  Scrum scrum;
  scrum.hear(1, {190, 130}, 16.0);  // 10 cm right of where this robot believes it, and 10 up-field
  ASSERT_TRUE(scrum.correct());
  EXPECT_NEAR(scrum.modes[0].pose.position.x, 190.0, 1.0);
  EXPECT_NEAR(scrum.modes[0].pose.position.y, 110.0, 1.0);
  EXPECT_LT(scrum.modes[0].covariance[0], 40.0);
}

TEST(BallLandmark, TurnsARobotWhosePlaceIsSurerThanItsHeading) {
  Scrum scrum;
  scrum.modes[0].covariance = {1, 0, 0, 0, 1, 0, 0, 0, 0.5};
  beginModels({Vector2(0.0, 100.0), Matrix2::Identity()}, 1.0, 0.9, scrum.ball);
  scrum.hear(1, {160, 200}, 9.0);  // 11 deg to the left of ahead
  ASSERT_TRUE(scrum.correct());
  EXPECT_NEAR(scrum.modes[0].pose.heading.deg(), 101.3, 1.0);
  EXPECT_NEAR(scrum.modes[0].pose.position.x, 180.0, 1.0);
}

TEST(BallLandmark, IsNoneWhereTheMateIsHardlySurer) {
  Scrum scrum;
  scrum.hear(1, {190, 130}, 300.0);
  EXPECT_FALSE(scrum.correct());
  EXPECT_EQ(scrum.modes.size(), 1U);
  EXPECT_EQ(scrum.modes[0].pose.position.x, 180.0);
}

TEST(BallLandmark, CorrectsOnceByEachMessage) {
  Scrum scrum;
  scrum.hear(7, {190, 130}, 16.0);
  EXPECT_TRUE(scrum.correct());
  EXPECT_FALSE(scrum.correct());
}

TEST(BallLandmark, NeedsABallThatBothHaveJustSeen) {
  Scrum unseen;
  unseen.ball.secondsSinceSeen = 0.5;
  unseen.hear(1, {190, 130}, 16.0);
  EXPECT_FALSE(unseen.correct());
  Scrum old;
  old.hear(1, {190, 130}, 16.0);
  old.players.mates[1].last.ball.secondsSinceSeen = 1.0;
  EXPECT_FALSE(old.correct());
}

// So that no robot takes its own ball back from a mate that it has corrected.
TEST(BallLandmark, NeverMakesARobotSoSureThatItsMateTakesTheBallBack) {
  Scrum scrum;
  for (std::uint16_t number = 1; number < 60; ++number) {
    scrum.hear(number, {182, 121}, 16.0);
    scrum.correct();
    scrum.modes.resize(1);
  }
  EXPECT_GT(scrum.ballVariance(), scrum.params.ballLandmark.surer * 16.0);
}

TEST(BallLandmark, FarFromWhereItCanBeLeavesTheRobotWhereItIs) {
  Scrum scrum;
  scrum.modes[0].covariance = {36, 0, 0, 0, 36, 0, 0, 0, 0.01};
  scrum.hear(1, {100, 300}, 9.0);
  ASSERT_TRUE(scrum.correct());
  ASSERT_EQ(scrum.modes.size(), 2U);
  EXPECT_GT(scrum.modes[1].weight, scrum.modes[0].weight);
  EXPECT_EQ(scrum.modes[1].pose.position.x, 180.0);
}

TEST(BallLandmark, IsNoneOfAMateThatIsCarriedOff) {
  Scrum scrum;
  scrum.hear(1, {190, 130}, 16.0);
  scrum.players.mates[1].last.note.role = Role::none;
  EXPECT_FALSE(scrum.correct());
}

TEST(BallLandmark, CanBeSwitchedOff) {
  Scrum scrum;
  scrum.params.ballLandmark.use = false;
  scrum.hear(1, {190, 130}, 16.0);
  EXPECT_FALSE(scrum.correct());
}

}  // namespace
}  // namespace kelpie::gps
