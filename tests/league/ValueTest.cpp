// SPDX-License-Identifier: Apache-2.0
// The value of play on made moments whose answer is known; the model is the source tree's where
// nothing else is said.
#include <gtest/gtest.h>

#include "tools/league/value/Judged.h"
#include "tools/league/value/Value.h"

namespace kelpie::value {
namespace {

const body::FieldDescription kField = *body::fieldDescription("2006");

Model shipped(bool far = false) {
  const auto models = readModels(modelFolder());
  if (!models) return {};
  return far ? models->far : models->near;
}

sim::RobotTruth robot(TeamColour team, std::uint8_t player, double x, double y, double deg) {
  return {team, player, {{x, y}, Angle::deg(deg)}, {}};
}

// Red's number 2 behind a ball, blue's far away in its corner.
sim::TruthFrame alone(double y) {
  sim::TruthFrame truth;
  truth.ball = {180.0, y};
  truth.robots.push_back(robot(TeamColour::red, 2, 180.0, y - 12.0, 90.0));
  truth.robots.push_back(robot(TeamColour::blue, 2, 20.0, 20.0, -90.0));
  return truth;
}

// The same moment with the teams exchanged and the field turned.
sim::TruthFrame turned(sim::TruthFrame truth) {
  truth.ball = {kField.width - truth.ball.x, kField.length - truth.ball.y};
  truth.ballVelocity = truth.ballVelocity * -1.0;
  for (sim::RobotTruth& each : truth.robots) {
    each.team = each.team == TeamColour::red ? TeamColour::blue : TeamColour::red;
    each.pose.position = {kField.width - each.pose.position.x,
                          kField.length - each.pose.position.y};
    each.pose.heading = each.pose.heading + Angle::deg(180.0);
  }
  return truth;
}

double red(const sim::TruthFrame& truth) { return valuesOf(shipped(), truth, kField)[0]; }

Features redFeatures(const sim::TruthFrame& truth) {
  return featuresOf(stateOf(truth, TeamColour::red, kField), kField);
}

TEST(Value, TheModelsOfTheSourceTreeAreRead) {
  const auto models = readModels(modelFolder());
  ASSERT_TRUE(models) << models.error();
  EXPECT_FALSE(models->near.curves.empty());
  EXPECT_FALSE(models->far.curves.empty());
  EXPECT_LT(models->near.horizon, models->far.horizon);
}

TEST(Value, AMirroredMomentIsWorthTheSameToTheOtherTeam) {
  sim::TruthFrame truth = alone(400.0);
  truth.ballVelocity = {30.0, 80.0};
  truth.robots.push_back(robot(TeamColour::blue, 1, 190.0, 520.0, -90.0));
  const TeamValues here = valuesOf(shipped(), truth, kField);
  const TeamValues there = valuesOf(shipped(), turned(truth), kField);
  EXPECT_NEAR(here[0], there[1], 1e-9);
  EXPECT_NEAR(here[1], there[0], 1e-9);
  const Model far = shipped(true);
  EXPECT_NEAR(valuesOf(far, truth, kField)[0], valuesOf(far, turned(truth), kField)[1], 1e-9);
}

TEST(Value, ABallBeforeAnEmptyGoalIsWorthMoreThanInMidfieldAndThatMoreThanBeforeTheOwnGoal) {
  EXPECT_GT(red(alone(500.0)), 3.0 * red(alone(270.0)));
  EXPECT_GT(red(alone(270.0)), red(alone(60.0)));
}

TEST(Value, ABallThatRollsIntoTheGoalIsWorthMoreThanOneThatLies) {
  sim::TruthFrame rolls = alone(440.0);
  rolls.ballVelocity = {0.0, 200.0};
  EXPECT_GT(red(rolls), red(alone(440.0)));
}

TEST(Value, IsAProbability) {
  for (double y = 10.0; y < 540.0; y += 10.0) {
    EXPECT_GT(red(alone(y)), 0.0);
    EXPECT_LT(red(alone(y)), 1.0);
  }
}

TEST(Features, ARobotInTheMouthLeavesLessOfItOpen) {
  sim::TruthFrame truth = alone(460.0);
  const Features open = redFeatures(truth);
  truth.robots.push_back(robot(TeamColour::blue, 1, 180.0, 530.0, 0.0));
  const Features kept = redFeatures(truth);
  EXPECT_NEAR(open.opening, open.mouth, 1e-9);
  EXPECT_NEAR(open.mouth, 2.0 * Angle::rad(maths::atan2(40.0, 80.0)).deg(), 1e-6);
  EXPECT_LT(kept.opening, 0.7 * open.opening);
  EXPECT_GT(kept.opening, 0.0);
}

TEST(Features, AFastBallEntersAndAKeeperInItsWayStopsIt) {
  sim::TruthFrame truth = alone(460.0);
  truth.ballVelocity = {0.0, 200.0};
  EXPECT_GT(redFeatures(truth).entering, 50.0);
  EXPECT_EQ(redFeatures(truth).free, redFeatures(truth).entering);
  EXPECT_EQ(redFeatures(truth).restGoal, 0.0);
  truth.robots.push_back(robot(TeamColour::blue, 1, 180.0, 530.0, 0.0));
  EXPECT_EQ(redFeatures(truth).free, 0.0);
  EXPECT_GT(redFeatures(truth).entering, 50.0);
}

TEST(Features, ABallThatRollsPastThePostDoesNotEnter) {
  sim::TruthFrame truth = alone(460.0);
  truth.ballVelocity = {150.0, 150.0};
  EXPECT_EQ(redFeatures(truth).entering, 0.0);
  EXPECT_GT(redFeatures(truth).restGoal, 0.0);
}

TEST(Features, WhoIsOffTheCarpetDoesNotPlay) {
  sim::TruthFrame truth = alone(300.0);
  EXPECT_EQ(redFeatures(truth).other, 1.0);
  truth.robots[1].pose.position = {-50.0, 300.0};
  EXPECT_EQ(redFeatures(truth).other, 0.0);
  EXPECT_EQ(redFeatures(truth).otherReach, kFar);
}

TEST(ValueModel, ACurveIsStraightBetweenItsPlacesAndLevelOutside) {
  const Curve curve{0, {10.0, 20.0, 40.0}, {0.0, 1.0, -1.0}};
  EXPECT_DOUBLE_EQ(heightOf(curve, -5.0), 0.0);
  EXPECT_DOUBLE_EQ(heightOf(curve, 15.0), 0.5);
  EXPECT_DOUBLE_EQ(heightOf(curve, 20.0), 1.0);
  EXPECT_DOUBLE_EQ(heightOf(curve, 30.0), 0.0);
  EXPECT_DOUBLE_EQ(heightOf(curve, 99.0), -1.0);
}

TEST(ValueModel, WhatIsNoModelGivesOneLine) {
  const char* const head = R"({"kelpie_value": 1, "horizon_s": 10, "base": -3, "curves": [)";
  const std::string broken[] = {
      "",
      "[1, 2]",
      R"({"kelpie_value": 2})",
      R"({"kelpie_value": 1, "horizon_s": 0, "base": 0, "curves": []})",
      std::string(head) + "7]}",
      std::string(head) + R"({"feature": "luck", "at": [0], "adds": [1]}]})",
      std::string(head) + R"({"feature": "goal", "at": [0, 0], "adds": [1, 2]}]})",
      std::string(head) + R"({"feature": "goal", "at": [0, 1], "adds": [1]}]})",
      std::string(head) + R"({"feature": "goal", "at": [], "adds": []}]})",
      std::string(head) + R"({"feature": "goal", "at": ["a"], "adds": [1]}]})"};
  for (const std::string& text : broken) {
    const auto model = modelFrom(text);
    ASSERT_FALSE(model) << text;
    EXPECT_EQ(model.error().find('\n'), std::string::npos);
  }
  EXPECT_TRUE(modelFrom(std::string(head) + "]}"));
  EXPECT_FALSE(readModel("no/such/file.json"));
  EXPECT_FALSE(readModels("no/such/folder"));
}

TEST(Judged, WhoKnowsTheShareAloneHasTheBaseLoss) {
  std::vector<Said> said(100);
  for (std::size_t i = 0; i < said.size(); ++i) said[i] = {0.1, i % 10 == 0};
  EXPECT_NEAR(logLoss(said), baseLogLoss(said), 1e-12);
  EXPECT_NEAR(calibrationError(binsOf(said, 1)), 0.0, 1e-12);
}

TEST(Judged, WhoIsRightHasNoLossAndWhoSaysTooMuchIsOffByThat) {
  std::vector<Said> right, much;
  for (int i = 0; i < 100; ++i) {
    right.push_back({i % 2 == 0 ? 1.0 : 0.0, i % 2 == 0});
    much.push_back({0.7, i % 2 == 0});
  }
  EXPECT_LT(logLoss(right), 1e-6);
  EXPECT_NEAR(calibrationError(binsOf(much, 1)), 0.2, 1e-12);
}

TEST(Judged, CorrelationIsOneOfWhatGoesTogetherAndNothingOfWhatStands) {
  EXPECT_NEAR(correlation({1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}), 1.0, 1e-12);
  EXPECT_NEAR(correlation({1.0, 2.0, 3.0}, {3.0, 2.0, 1.0}), -1.0, 1e-12);
  EXPECT_EQ(correlation({1.0, 1.0}, {0.0, 2.0}), 0.0);
}

TEST(Judged, AStretchThatEndsBeforeTheHorizonByNoGoalTellsNothing) {
  const Model model{10.0, 0.0, {}};
  const std::vector<Row> rows = {{0.0, TeamColour::red, 5.0, 0, {}},
                                 {0.0, TeamColour::red, 5.0, 1, {}},
                                 {0.0, TeamColour::red, 5.0, -1, {}},
                                 {0.0, TeamColour::red, 50.0, 1, {}}};
  const std::vector<Said> said = saidOf(rows, model);
  ASSERT_EQ(said.size(), 3U);
  EXPECT_TRUE(said[0].was);
  EXPECT_FALSE(said[1].was);
  EXPECT_FALSE(said[2].was);
  EXPECT_DOUBLE_EQ(said[0].p, 0.5);
}

}  // namespace
}  // namespace kelpie::value
