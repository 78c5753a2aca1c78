// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/Touch.h"

namespace kelpie::sim {
namespace {

// Red behind a ball that lies ahead of it, blue so far from the ball.
MadeScene duel(double blueAway) {
  MadeScene scene;
  scene.with(kRed, 2, {180, 250}).with(kBlue, 3, {180, 270 + blueAway}, -90);
  return scene;
}

TEST(Touch, NobodyTouchedABallThatLies) {
  MadeScene scene = duel(15);
  TouchState state;
  scene.goesOn(1.0, [&](MadeScene& now) { EXPECT_FALSE(step(now, ruleField(), state)); });
}

TEST(Touch, TheNearestRobotTouchedTheBallThatWasJolted) {
  for (const bool redNearer : {true, false}) {
    MadeScene scene = duel(redNearer ? 25 : 15);
    TouchState state;
    step(scene, ruleField(), state);
    scene.ball.velocity = {50, 0};
    EXPECT_EQ(step(scene, ruleField(), state), std::optional<std::size_t>(redNearer ? 0 : 1));
  }
}

TEST(Touch, TheOneFartherOffFromWhichTheBallJumpsAwayTouchedIt) {
  MadeScene scene = duel(22);
  scene.players[0].pose.position.y = 245;  // its head 17 cm off, blue's 14
  TouchState state;
  step(scene, ruleField(), state);
  scene.ball.velocity = {0, 50};
  EXPECT_EQ(step(scene, ruleField(), state), std::optional<std::size_t>(0));
}

TEST(Touch, ARollingBallThatSlowsDownWasNotTouched) {
  MadeScene scene = duel(15);
  scene.ball.velocity = {200, 0};
  TouchState state;
  scene.goesOn(0.5, [&](MadeScene& now) {
    now.ball.velocity = now.ball.velocity * 0.994;
    EXPECT_FALSE(step(now, ruleField(), state));
  });
}

TEST(Touch, AJoltFarFromRobotsIsAPosts) {
  MadeScene scene = duel(60);
  scene.ball.position = {180, 310};
  TouchState state;
  step(scene, ruleField(), state);
  scene.ball.velocity = {0, 50};
  scene.players[1].pose.position.y = 360;
  EXPECT_FALSE(step(scene, ruleField(), state));
}

TEST(Touch, WhoHoldsTheBallTouchesItAndItIsRemembered) {
  MadeScene scene = duel(80);
  scene.ball.position = {180, 258};
  TouchState state;
  EXPECT_EQ(step(scene, ruleField(), state), std::optional<std::size_t>(0));
  scene.ball.position = {20, 20};
  EXPECT_EQ(step(scene, ruleField(), state), std::optional<std::size_t>(0));
}

// Blue shoots at the red goal; red's goalie, in its way, pushes the ball on or aside.
TEST(Touch, AShotThatTheGoalsOwnSideTurnsInStaysTheShooters) {
  for (const bool onTarget : {true, false}) {
    MadeScene scene;
    scene.with(kBlue, 3, {180, 130}, -90).with(kRed, 1, {180, 30});
    scene.ball.position = {180, 115};
    TouchState state;
    step(scene, ruleField(), state);
    scene.ball.velocity = {onTarget ? 0.0 : 150.0, -150};
    step(scene, ruleField(), state);
    scene.ball.position = {180, 50};
    step(scene, ruleField(), state);
    scene.ball.velocity = {20, -60};
    EXPECT_EQ(step(scene, ruleField(), state), std::optional<std::size_t>(1)) << onTarget;
    EXPECT_EQ(state.scorer, std::optional<std::size_t>(onTarget ? 0 : 1)) << onTarget;
  }
}

TEST(Touch, AShotTooSlowToComeInIsNoMoreTheShooters) {
  MadeScene scene;
  scene.with(kBlue, 3, {180, 130}, -90).with(kRed, 1, {180, 75});
  scene.ball.position = {180, 115};
  TouchState state;
  step(scene, ruleField(), state);
  scene.ball.velocity = {0, -60};  // rolls 80 cm
  step(scene, ruleField(), state);
  scene.ball.position = {180, 95};
  scene.ball.velocity = {0, -90};
  step(scene, ruleField(), state);
  EXPECT_EQ(state.scorer, std::optional<std::size_t>(1));
}

}  // namespace
}  // namespace kelpie::sim
