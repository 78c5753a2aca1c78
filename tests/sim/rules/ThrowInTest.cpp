// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/ThrowIn.h"

namespace kelpie::sim {
namespace {

struct Left {
  const char* fact;
  Point2<Field> ball;
  Point2<Field> put;
  const char* line;
};

constexpr Left kLeft[] = {
    {"left side", {-5, 300}, {40, 300}, "over the side line"},
    {"right side", {365, 200}, {320, 200}, "over the side line"},
    {"side near a goal line", {-5, 30}, {40, 100}, "over the side line"},
    {"red's goal line", {100, -5}, {40, 100}, "over the goal line"},
    {"blue's goal line", {300, 545}, {320, 440}, "over the goal line"},
    {"corner", {365, 545}, {320, 440}, "over the corner"},
};

TEST(ThrowIn, ABallIsPutBackByTheSideWhereItLeft) {
  for (const Left& left : kLeft) {
    MadeScene scene;
    scene.ball.position = left.ball;
    EXPECT_TRUE(ballOut(ruleField(), left.ball)) << left.fact;
    EXPECT_EQ(distance(throwIn(ruleField(), scene), left.put), 0.0) << left.fact;
    EXPECT_STREQ(outOver(ruleField(), left.ball), left.line) << left.fact;
  }
}

TEST(ThrowIn, ABallOnTheLineIsNotOut) {
  EXPECT_FALSE(ballOut(ruleField(), {-4.0, 300}));
  EXPECT_FALSE(ballOut(ruleField(), {100, 544.0}));
}

TEST(ThrowIn, ABallIsNotPutIntoARobot) {
  MadeScene scene;
  scene.with(kBlue, 2, {40, 305});
  scene.ball.position = {-5, 300};
  const Point2<Field> put = throwIn(ruleField(), scene);
  EXPECT_EQ(put.x, 40.0);
  EXPECT_GT(stripeDistance(scene.players[0].pose, put), 13.0);
  scene.players[0].playing = false;
  EXPECT_EQ(throwIn(ruleField(), scene).y, 300.0);
}

TEST(ThrowIn, AStuckBallDropsAtTheNearestPlaceOrAtTheOtherSide) {
  MadeScene scene;
  scene.ball.position = {100, 20};
  EXPECT_EQ(distance(dropIn(ruleField(), scene), {40, 100}), 0.0);
  scene.ball.position = {41, 102};
  EXPECT_EQ(distance(dropIn(ruleField(), scene), {320, 102}), 0.0);
}

}  // namespace
}  // namespace kelpie::sim
