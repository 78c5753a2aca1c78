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
  scene.goesOn(1.0, [&](MadeScene& now) { EXPECT_FALSE(step(now, state)); });
}

TEST(Touch, TheNearestRobotTouchedTheBallThatWasJolted) {
  for (const bool redNearer : {true, false}) {
    MadeScene scene = duel(redNearer ? 25 : 15);
    TouchState state;
    step(scene, state);
    scene.ball.velocity = {0, 50};
    EXPECT_EQ(step(scene, state), std::optional<std::size_t>(redNearer ? 0 : 1));
  }
}

TEST(Touch, ARollingBallThatSlowsDownWasNotTouched) {
  MadeScene scene = duel(15);
  scene.ball.velocity = {200, 0};
  TouchState state;
  scene.goesOn(0.5, [&](MadeScene& now) {
    now.ball.velocity = now.ball.velocity * 0.994;
    EXPECT_FALSE(step(now, state));
  });
}

TEST(Touch, AJoltFarFromRobotsIsAPosts) {
  MadeScene scene = duel(60);
  scene.ball.position = {180, 310};
  TouchState state;
  step(scene, state);
  scene.ball.velocity = {0, 50};
  scene.players[1].pose.position.y = 360;
  EXPECT_FALSE(step(scene, state));
}

TEST(Touch, WhoHoldsTheBallTouchesItAndItIsRemembered) {
  MadeScene scene = duel(80);
  scene.ball.position = {180, 258};
  TouchState state;
  EXPECT_EQ(step(scene, state), std::optional<std::size_t>(0));
  scene.ball.position = {20, 20};
  EXPECT_EQ(step(scene, state), std::optional<std::size_t>(0));
}

}  // namespace
}  // namespace kelpie::sim
