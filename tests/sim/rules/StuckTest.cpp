// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/Stuck.h"

namespace kelpie::sim {
namespace {

// When the ball first counts as stuck, with what happens in each tick; 0 = not in two minutes.
template <class F>
double stuckAfter(double robotAway, F&& happens) {
  MadeScene scene;
  scene.with(kRed, 2, {180, 270 - robotAway});
  StuckState state;
  double stuck = 0.0;
  scene.goesOn(120.0, [&](MadeScene& now) {
    happens(now);
    if (step(now, body::Rules{}, state) && stuck == 0.0) stuck = now.time.seconds();
  });
  return stuck;
}

TEST(Stuck, ABallThatRobotsAreAtAndDoNotMove) {
  EXPECT_NEAR(stuckAfter(20, [](MadeScene&) {}), 25.0, 0.03);
}

TEST(Stuck, ABallThatNobodyIsAtIsNot) {
  EXPECT_EQ(stuckAfter(60, [](MadeScene&) {}), 0.0);
  EXPECT_EQ(stuckAfter(20, [](MadeScene& now) { now.players[0].playing = false; }), 0.0);
}

TEST(Stuck, ABallThatGoesElevenCentimetresIsNot) {
  const auto goes = [](double way) {
    return [way](MadeScene& now) {
      now.ball.position.x = 180 + (now.time.us / 20000000 % 2 == 0 ? 0.0 : way);
    };
  };
  EXPECT_EQ(stuckAfter(20, goes(11.0)), 0.0);
  EXPECT_NEAR(stuckAfter(20, goes(9.0)), 25.0, 0.03);
}

}  // namespace
}  // namespace kelpie::sim
