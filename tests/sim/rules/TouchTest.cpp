// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/Touch.h"

namespace kelpie::sim {
namespace {

constexpr std::size_t kShooter = 0, kKeeper = 1;
// Who touched the ball is still at it, and is no more.
constexpr TimeUs kSoon{200000}, kLater{310000};

// A blue robot shoots at the red goal; red's goalie stands in the ball's way.
struct Shot {
  MadeScene scene;
  TouchState state;

  Shot() { scene.with(kBlue, 3, {180, 130}, -90).with(kRed, 1, {180, 30}); }

  std::optional<std::size_t> touched(std::optional<std::size_t> by, const Ball& ball) {
    scene.ball = ball;
    scene.ballToucher = by;
    return step(scene, ruleField(), state);
  }
  void rolls(const Ball& ball) { touched(std::nullopt, ball); }
  // Two robots press at a slow ball before the goal line, by turns, so that it jolts; the goalie
  // touches it again at that time.
  void squeezed(TimeUs again) {
    touched(kShooter, {{180, 20}, {0, -8}});
    touched(kKeeper, {{180, 20}, {3, 9}});
    scene.time = again;
    touched(kKeeper, {{180, 19}, {3, -20}});
  }
};

TEST(Touch, NobodyTouchedABallThatLies) {
  Shot shot;
  EXPECT_FALSE(shot.touched(std::nullopt, {{180, 115}, {}}));
}

TEST(Touch, WhoTouchedTheBallIsRememberedUntilAnotherDoes) {
  Shot shot;
  EXPECT_EQ(shot.touched(kShooter, {{180, 115}, {0, -90}}), kShooter);
  EXPECT_EQ(shot.touched(std::nullopt, {{180, 90}, {0, -80}}), kShooter);
  EXPECT_EQ(shot.touched(kKeeper, {{180, 45}, {30, 20}}), kKeeper);
}

TEST(Touch, WhoIsOffTheFieldTouchesNothing) {
  Shot shot;
  shot.scene.players[kShooter].playing = false;
  EXPECT_FALSE(shot.touched(kShooter, {{180, 115}, {0, -90}}));
}

TEST(Touch, AShotThatTheGoalsOwnSideTurnsInStaysTheShooters) {
  for (const bool onTarget : {true, false}) {
    Shot shot;
    const Point2<Field> velocity{onTarget ? 0.0 : 150.0, -150};
    shot.touched(kShooter, {{180, 115}, velocity});
    shot.rolls({{180, 50}, velocity});
    shot.scene.time = kLater;
    EXPECT_EQ(shot.touched(kKeeper, {{180, 45}, {20, -60}}), kKeeper) << onTarget;
    EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(onTarget ? kShooter : kKeeper))
        << onTarget;
  }
}

TEST(Touch, AShotThatWasKeptOutAndThenPushedInIsTheKeepersGoal) {
  Shot shot;
  shot.touched(kShooter, {{180, 115}, {0, -150}});
  shot.touched(kKeeper, {{180, 45}, {}});
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kShooter));
  shot.scene.time = kLater;
  shot.touched(kKeeper, {{180, 44}, {0, -60}});
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kKeeper));
}

// As in a match: stopped by the chest, and turned in by a leg 0.07 s later.
TEST(Touch, ASaveOfSeveralTouchesThatEndsInTheGoalStaysTheShooters) {
  Shot shot;
  shot.touched(kShooter, {{180, 115}, {0, -150}});
  shot.touched(kKeeper, {{180, 45}, {20, -2}});
  shot.rolls({{180, 44}, {20, -2}});
  shot.scene.time = TimeUs::fromSeconds(0.07);
  shot.touched(kKeeper, {{180, 44}, {0, -60}});
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kShooter));
}

TEST(Touch, ASaveDoesNotOutlastAnothersTouch) {
  Shot shot;
  shot.touched(kShooter, {{180, 115}, {0, -150}});
  shot.touched(kKeeper, {{180, 45}, {100, 100}});
  shot.touched(kShooter, {{190, 60}, {150, 0}});
  shot.scene.time = kLater;
  shot.touched(kKeeper, {{195, 60}, {0, -60}});
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kKeeper));
}

TEST(Touch, ABallThatTwoAreAtIsOfWhoPlaysTowardsTheGoal) {
  Shot shot;
  shot.squeezed(kSoon);
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kShooter));
  EXPECT_EQ(shot.state.last, std::optional<std::size_t>(kKeeper));
}

TEST(Touch, ABallThatItsOwnSideAloneTakesInIsAnOwnGoal) {
  Shot shot;
  shot.squeezed(kLater);
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kKeeper));
}

TEST(Touch, WhoScoresAtTheOtherEndAfterTheirOwnSideTouchedTheBallScoresNoOwnGoal) {
  for (const double speed : {0.0, 40.0}) {  // lying, and played up-field
    Shot shot;
    shot.touched(kKeeper, {{180, 100}, {0, 60}});
    shot.rolls({{180, 115}, {0, speed}});
    shot.touched(kShooter, {{180, 115}, {0, -150}});
    EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kShooter)) << speed;
  }
}

TEST(Touch, AtTheOtherGoalTheSidesAreTurned) {
  for (const TimeUs time : {kSoon, kLater}) {
    Shot shot;
    shot.touched(kKeeper, {{180, 520}, {0, 8}});  // red presses at blue's goal
    shot.touched(kShooter, {{180, 520}, {3, -9}});
    shot.scene.time = time;
    shot.touched(kShooter, {{180, 522}, {3, 20}});
    EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(time == kSoon ? kKeeper : kShooter));
  }
}

TEST(Touch, AShotTooSlowToComeInIsNoMoreTheShooters) {
  Shot shot;
  shot.touched(kShooter, {{180, 115}, {0, -60}});  // rolls 80 cm
  shot.scene.time = kLater;
  shot.touched(kKeeper, {{180, 95}, {0, -90}});
  EXPECT_EQ(shot.state.scorer, std::optional<std::size_t>(kKeeper));
}

}  // namespace
}  // namespace kelpie::sim
